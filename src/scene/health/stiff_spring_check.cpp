// Springs stiffer than the steps can follow, which the solver makes softer.
#include <optional>
#include <string>
#include <variant>

#include "scene/health/health_check.hpp"
#include "scene/model/display.hpp"

namespace tumble::scene {

namespace {

// The largest frequency of the springs of a joint, Hz; 0 without.
double stiffness_of(const JointDef& joint) {
    return std::visit(
        [](const auto& def) {
            double hertz = 0.0;
            const auto add = [&](const std::optional<JointSpring>& spring) {
                if (spring) hertz = std::max(hertz, double{spring->hertz});
            };
            if constexpr (requires { def.spring; }) add(def.spring);
            if constexpr (requires { def.linear_spring; }) add(def.linear_spring), add(def.angular_spring);
            return hertz;
        },
        joint);
}

class SpringCheck final : public HealthCheck {
public:
    void observe(const HealthView& view) override {
        if (!view.is_first()) return;  // all joints are there from the start, and events do not change springs
        for (std::size_t i = 0; i < view.built().joints.size(); ++i) note(view, i);
    }

    void report(const HealthView&, std::vector<HealthFinding>& findings) const override {
        culprits_.append_to(findings);
    }

private:
    void note(const HealthView& view, std::size_t joint) {
        const JointDef& def = view.world().joint(view.built().joints[joint].id);
        const double hertz = stiffness_of(def), limit = double{view.limits().stiffest_spring};
        const Culprit culprit{{joint}, {view.built().joints[joint].source}};
        if (!(hertz > limit) || !culprits_.is_worst(culprit, hertz)) return;
        const std::string name = display_joint_name(view.built(), joint);
        const auto [a, b] = std::visit([](const auto& each) { return std::pair(each.body_a, each.body_b); }, def);
        culprits_.set(culprit, {.check = "stiff_spring",
                                .subject = name,
                                .text = "the spring of the joint " + name + " has " + brief(hertz) +
                                        " Hz, which a step limits to " + brief(limit) + " Hz",
                                .remedy = "Use more \"substeps\" or \"steps_per_second\", or a softer spring.",
                                .step = view.step(),
                                .time = view.world().time(),
                                .bodies = {a, b},
                                .value = hertz,
                                .limit = limit,
                                .unit = "Hz"});
    }

    Culprits culprits_;
};

}  // namespace

std::unique_ptr<HealthCheck> make_spring_check() { return std::make_unique<SpringCheck>(); }

}  // namespace tumble::scene
