// Bodies deep inside each other: at the start, or pressed together for longer than contacts need to part them.
#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "scene/health/health_check.hpp"
#include "scene/lint/measures.hpp"
#include "scene/model/display.hpp"

namespace tumble::scene {

namespace {

constexpr double kCorePart = 0.25;  // of the smaller extent: beyond it the cores of the two shapes overlap

class OverlapCheck final : public HealthCheck {
public:
    void observe(const HealthView& view) override {
        std::map<Pair, const ContactPoint*> deepest;
        for (const ContactPoint& contact : view.contacts()) {
            if (!(-double{contact.separation} > limit_of(view, pair_of(view, contact)))) continue;
            const ContactPoint*& found = deepest.try_emplace(pair_of(view, contact), &contact).first->second;
            if (contact.separation < found->separation) found = &contact;
        }
        std::map<Pair, std::uint64_t> pressed;
        for (const auto& [pair, contact] : deepest) observe_pair(view, pair, *contact, pressed);
        pressed_ = std::move(pressed);
    }

    void report(const HealthView&, std::vector<HealthFinding>& findings) const override {
        culprits_.append_to(findings);
    }

private:
    using Pair = std::pair<std::size_t, std::size_t>;

    static Pair pair_of(const HealthView& view, const ContactPoint& contact) {
        return {view.index_of(contact.body_a), view.index_of(contact.body_b)};
    }

    // The separation is that at the start of the step, in which a spawned body is first seen.
    static bool is_start(const HealthView& view, const Pair& pair) {
        return view.step() <= 1 + std::max(view.bodies()[pair.first].born, view.bodies()[pair.second].born);
    }

    // m: that of the start is the smaller one.
    static double limit_of(const HealthView& view, const Pair& pair) {
        const double extent = std::min(view.bodies()[pair.first].smallest, view.bodies()[pair.second].smallest);
        return is_start(view, pair) ? allowed_overlap(extent, view.scale()) : kCorePart * extent;
    }

    // Of a pair beyond its limit.
    void observe_pair(const HealthView& view, const Pair& pair, const ContactPoint& contact,
                      std::map<Pair, std::uint64_t>& pressed) {
        const double limit = limit_of(view, pair);
        if (is_start(view, pair)) return note(view, pair, contact, limit);
        const auto before = pressed_.find(pair);
        const std::uint64_t steps = before == pressed_.end() ? 1 : before->second + 1;
        pressed[pair] = steps;
        if (steps >= view.patience()) note(view, pair, contact, limit, true);
    }

    void note(const HealthView& view, const Pair& pair, const ContactPoint& contact, double limit,
              bool is_pressed = false) {
        const double depth = -double{contact.separation};
        const double extent = std::min(view.bodies()[pair.first].smallest, view.bodies()[pair.second].smallest);
        const auto [low, high] = std::minmax({view.source(pair.first), view.source(pair.second)});
        const Culprit culprit{{pair.first, pair.second}, {low, high}};
        if (!culprits_.is_worst(culprit, depth / extent)) return;
        HealthFinding finding{.check = "overlap",
                              .subject = view.name(pair.second) + " and " + view.name(pair.first),
                              .step = view.step(),
                              .time = view.world().time(),
                              .bodies = {contact.body_a, contact.body_b},
                              .point = contact.point,
                              .value = depth,
                              .limit = limit,
                              .unit = "m"};
        describe(view, pair, is_pressed, finding);
        culprits_.set(culprit, std::move(finding));
    }

    static void describe(const HealthView& view, const Pair& pair, bool is_pressed, HealthFinding& finding) {
        const std::string a = view.name(pair.first), b = view.name(pair.second), depth = brief(finding.value) + " m";
        if (is_pressed) {
            finding.text = b + " stays pressed " + depth + " into " + a + ", more than a quarter of the smaller one";
            const double mass_a = view.bodies()[pair.first].mass, mass_b = view.bodies()[pair.second].mass;
            const double ratio = std::max(mass_a, mass_b) / std::min(mass_a, mass_b);
            if (std::isfinite(ratio) && ratio > kLargeMassRatio)
                finding.text += "; one is " + brief(ratio) + " times heavier than the other";
            finding.remedy =
                "A contact yields to a load: stack fewer or lighter bodies, bring their densities closer together, or "
                "use more \"substeps\".";
        } else {
            finding.text = b + " starts " + depth + " inside " + a + ": they are pushed apart at up to " +
                           brief(double{view.limits().push_out_speed}) + " m/s";
            finding.remedy = "Move one of them, or let a \"filter\" exclude their contact.";
        }
    }

    std::map<Pair, std::uint64_t> pressed_;  // the steps for which a pair has been pressed together
    Culprits culprits_;
};

}  // namespace

std::unique_ptr<HealthCheck> make_overlap_check() { return std::make_unique<OverlapCheck>(); }

}  // namespace tumble::scene
