// Joints whose anchors are apart, or that are beyond their limits.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "scene/health/health_check.hpp"
#include "scene/lint/measures.hpp"
#include "scene/model/display.hpp"
#include "scene/model/joint_gap.hpp"

namespace tumble::scene {

namespace {

// How far the free motion of a joint is beyond its limits, as the displacement of the farthest point of a body of this
// size (m).
double beyond_limits(const World& world, JointId id, double size) {
    return std::visit(
        [&](const auto& def) {
            if constexpr (requires { def.limits; }) {
                if (!def.limits) return 0.0;
                const double position = world.joint_motion(id).position;
                const double excess =
                    std::max({0.0, double{def.limits->lower} - position, position - double{def.limits->upper}});
                return std::is_same_v<std::decay_t<decltype(def)>, RevoluteJointDef> ? excess * size : excess;
            }
            return 0.0;
        },
        world.joint(id));
}

class JointCheck final : public HealthCheck {
public:
    void observe(const HealthView& view) override {
        open_.resize(view.built().joints.size());
        for (std::size_t i = 0; i < view.built().joints.size(); ++i)
            if (view.world().is_valid(view.built().joints[i].id)) observe_joint(view, i);
    }

    void report(const HealthView&, std::vector<HealthFinding>& findings) const override {
        culprits_.append_to(findings);
    }

private:
    void observe_joint(const HealthView& view, std::size_t joint) {
        const JointId id = view.built().joints[joint].id;
        const auto [a, b] =
            std::visit([](const auto& def) { return std::pair(def.body_a, def.body_b); }, view.world().joint(id));
        const SeenBody &seen_a = view.bodies()[view.index_of(a)], &seen_b = view.bodies()[view.index_of(b)];
        const double size = smaller_size(seen_a.largest, seen_b.largest);
        if (!(size > 0.0)) return;
        const double gap = joint_gap(view.world(), id), excess = beyond_limits(view.world(), id, size);
        const double value = std::max(gap, excess), limit = kWideGap * size;
        open_[joint] = value > limit ? open_[joint] + 1 : 0;
        if (open_[joint] == 0 || (!view.is_first() && open_[joint] < view.patience())) return;
        const Culprit culprit{{joint}, {view.built().joints[joint].source}};
        if (!culprits_.is_worst(culprit, value / size)) return;
        HealthFinding finding{.check = "joint_error",
                              .subject = display_joint_name(view.built(), joint),
                              .step = view.step(),
                              .time = view.world().time(),
                              .bodies = {a, b},
                              .value = value,
                              .limit = limit,
                              .unit = "m"};
        if (const std::optional<JointAnchors> anchors = view.world().joint_anchors(id)) finding.point = anchors->b;
        describe(view, seen_a, seen_b, excess > gap, finding);
        culprits_.set(culprit, std::move(finding));
    }

    static void describe(const HealthView& view, const SeenBody& a, const SeenBody& b, bool beyond,
                         HealthFinding& finding) {
        const std::string bodies = view.name(view.index_of(a.id)) + " and " + view.name(view.index_of(b.id));
        const std::string value = brief(finding.value) + " m";
        if (view.is_first()) {
            finding.text = "the joint " + finding.subject + " starts " + value +
                           " away from a position that it allows for " + bodies;
            finding.remedy = "Correct its anchors, its \"length\" or its \"limits\", or move the bodies.";
            return;
        }
        finding.text = "the joint " + finding.subject + " of " + bodies + " is " + value +
                       (beyond ? " beyond its limits" : " apart");
        const double ratio = a.is_dynamic && b.is_dynamic ? std::max(a.mass, b.mass) / std::min(a.mass, b.mass) : 1.0;
        if (ratio > kLargeMassRatio) {
            finding.text += ": one body is " + brief(ratio) + " times heavier than the other";
            finding.remedy =
                "Bring the densities of the bodies closer together, use \"joints\": \"direct\", or more \"substeps\".";
        } else if (beyond) {
            finding.remedy =
                "Lower the torque or force of the motor or of the load on the joint, or use more \"substeps\".";
        } else {
            finding.remedy =
                "Use \"joints\": \"direct\" or more \"substeps\", lower the load on the joint, or give it a "
                "\"break_force\".";
        }
    }

    std::vector<std::uint64_t> open_;  // [built joints] steps for which it has been apart
    Culprits culprits_;
};

}  // namespace

std::unique_ptr<HealthCheck> make_joint_check() { return std::make_unique<JointCheck>(); }

}  // namespace tumble::scene
