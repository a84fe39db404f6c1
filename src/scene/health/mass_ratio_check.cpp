// Heavy bodies that rest on light ones, which their contact squeezes. Only what holds a heavy body up against gravity
// counts, not what presses it from the side or from above.
#include <algorithm>
#include <map>
#include <string>

#include "scene/health/health_check.hpp"
#include "scene/lint/measures.hpp"
#include "scene/model/display.hpp"

namespace tumble::scene {

namespace {

class MassCheck final : public HealthCheck {
public:
    void observe(const HealthView& view) override {
        std::map<Pair, Load> loads;
        for (const ContactPoint& contact : view.contacts()) add(view, contact, loads);
        std::erase_if(loads, [&](const auto& entry) {
            const double weight = view.bodies()[entry.first.second].mass * view.gravity() * view.step_duration();
            return !(entry.second.impulse > kLargeMassRatio * weight);
        });
        for (auto& [pair, load] : loads) {
            const auto before = loads_.find(pair);
            if (before != loads_.end()) load.steps = before->second.steps + 1;
            if (load.steps >= view.steps_to_sleep()) note(view, pair, load);
        }
        loads_ = std::move(loads);
    }

    void report(const HealthView&, std::vector<HealthFinding>& findings) const override {
        culprits_.append_to(findings);
    }

private:
    using Pair = std::pair<std::size_t, std::size_t>;  // the heavy body, the light one
    struct Load {
        double impulse = 0.0;  // N s against gravity, in the step
        DVec2 point;
        std::uint64_t steps = 1;
    };

    static void add(const HealthView& view, const ContactPoint& contact, std::map<Pair, Load>& loads) {
        const std::size_t a = view.index_of(contact.body_a), b = view.index_of(contact.body_b);
        const SeenBody &seen_a = view.bodies()[a], &seen_b = view.bodies()[b];
        if (!seen_a.is_dynamic || !seen_b.is_dynamic || !(view.gravity() > 0.0)) return;
        if (!(mass_ratio(view.world(), seen_a.id, seen_b.id) > kLargeMassRatio)) return;
        const bool heavy_is_a = seen_a.mass > seen_b.mass;
        const double down = dot(DVec2(contact.normal), DVec2(view.world().def().gravity)) / view.gravity();
        const double lift = std::max(0.0, heavy_is_a ? down : -down);  // the part of the impulse that carries
        if (lift == 0.0) return;
        Load& load = loads[heavy_is_a ? Pair{a, b} : Pair{b, a}];
        load.impulse += double{contact.normal_impulse} * lift;
        load.point = contact.point;
    }

    void note(const HealthView& view, const Pair& pair, const Load& load) {
        const SeenBody &heavy = view.bodies()[pair.first], &light = view.bodies()[pair.second];
        const double ratio = heavy.mass / light.mass;
        const Culprit culprit{{pair.first, pair.second}, {view.source(pair.first), view.source(pair.second)}};
        if (!culprits_.is_worst(culprit, ratio)) return;
        culprits_.set(culprit, {.check = "mass_ratio",
                                .subject = view.name(pair.first) + " on " + view.name(pair.second),
                                .text = view.name(pair.first) + " of " + brief(heavy.mass) + " kg rests on " +
                                        view.name(pair.second) + " of " + brief(light.mass) + " kg: it is " +
                                        brief(ratio) + " times heavier, and squeezes it",
                                .remedy = "Bring their densities closer together, or use more \"substeps\".",
                                .step = view.step(),
                                .time = view.world().time(),
                                .bodies = {heavy.id, light.id},
                                .point = load.point,
                                .value = ratio,
                                .limit = kLargeMassRatio});
    }

    std::map<Pair, Load> loads_;  // of the last state
    Culprits culprits_;
};

}  // namespace

std::unique_ptr<HealthCheck> make_mass_check() { return std::make_unique<MassCheck>(); }

}  // namespace tumble::scene
