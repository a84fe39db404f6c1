// Motors that press a joint against its limit with far more than the bodies weigh: the limit has to hold all of it.
#include <algorithm>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "scene/health/health_check.hpp"
#include "scene/lint/measures.hpp"
#include "scene/model/display.hpp"

namespace tumble::scene {

namespace {

constexpr double kNear = 0.01;  // rad or m: a limit is soft, and the motor presses the joint into it

// A motor along a free motion that has limits.
struct LimitedMotor {
    double speed = 0.0;   // rad/s or m/s
    double effort = 0.0;  // N m or N, the largest
    double lower = 0.0, upper = 0.0;
    bool turns = false;
};

// The motor of a wheel joint turns, and its limits are those of the suspension.
std::optional<LimitedMotor> limited_motor(const JointDef& joint) {
    return std::visit(
        [](const auto& def) -> std::optional<LimitedMotor> {
            using Def = std::decay_t<decltype(def)>;
            if constexpr (requires { def.motor->max_torque; } && std::is_same_v<Def, RevoluteJointDef>) {
                if (def.motor && def.limits)
                    return LimitedMotor{double{def.motor->speed}, double{def.motor->max_torque},
                                        double{def.limits->lower}, double{def.limits->upper}, true};
            } else if constexpr (requires { def.motor->max_force; }) {
                if (def.motor && def.limits)
                    return LimitedMotor{double{def.motor->speed}, double{def.motor->max_force},
                                        double{def.limits->lower}, double{def.limits->upper}, false};
            }
            return std::nullopt;
        },
        joint);
}

class MotorCheck final : public HealthCheck {
public:
    void observe(const HealthView& view) override {
        pressed_.resize(view.built().joints.size());
        for (std::size_t i = 0; i < pressed_.size(); ++i) {
            const JointId id = view.built().joints[i].id;
            if (!view.world().is_valid(id)) continue;
            const std::optional<LimitedMotor> motor = limited_motor(view.world().joint(id));
            if (!motor) continue;
            const double position = view.world().joint_motion(id).position;
            const bool is_pressed = (motor->speed > 0.0 && position > motor->upper - kNear) ||
                                    (motor->speed < 0.0 && position < motor->lower + kNear);
            pressed_[i] = is_pressed ? pressed_[i] + 1 : 0;
            if (pressed_[i] >= view.patience()) test(view, i, *motor);
        }
    }

    void report(const HealthView&, std::vector<HealthFinding>& findings) const override {
        culprits_.append_to(findings);
    }

private:
    void test(const HealthView& view, std::size_t joint, const LimitedMotor& motor) {
        const auto [a, b] = std::visit([](const auto& def) { return std::pair(def.body_a, def.body_b); },
                                       view.world().joint(view.built().joints[joint].id));
        double load = 0.0;  // N m or N: what it takes to carry the heavier of the two bodies
        for (const BodyId id : {a, b}) {
            const SeenBody& body = view.bodies()[view.index_of(id)];
            load = std::max(load, body.mass * view.gravity() * (motor.turns ? body.largest : 1.0));
        }
        const Culprit culprit{{joint}, {view.built().joints[joint].source}};
        if (!(load > 0.0) || !(motor.effort > kLargeMassRatio * load) ||
            !culprits_.is_worst(culprit, motor.effort / load))
            return;
        const std::string name = display_joint_name(view.built(), joint), unit = motor.turns ? "N m" : "N";
        culprits_.set(
            culprit,
            {.check = "motor",
             .subject = name,
             .text = "the motor of the joint " + name + " presses against the limit with up to " + brief(motor.effort) +
                     " " + unit + ", " + brief(motor.effort / load) + " times what carries the heavier body",
             .remedy = motor.turns ? "Lower \"max_torque\", or set \"motor_speed\" to 0 when the limit is reached."
                                   : "Lower \"max_force\", or set \"motor_speed\" to 0 when the limit is reached.",
             .step = view.step(),
             .time = view.world().time(),
             .bodies = {a, b},
             .value = motor.effort,
             .limit = kLargeMassRatio * load,
             .unit = unit});
    }

    std::vector<std::uint64_t> pressed_;  // [built joints] steps for which it has been at the limit
    Culprits culprits_;
};

}  // namespace

std::unique_ptr<HealthCheck> make_motor_check() { return std::make_unique<MotorCheck>(); }

}  // namespace tumble::scene
