// Checks of joint definitions. Members that several kinds of joint have are checked by their names, the rest kind by
// kind.
#include <cmath>
#include <optional>

#include "world/input_checks.hpp"
#include "world/require.hpp"

namespace tumble {

namespace {

void check_part(const JointLimits& limits) {
    require_finite(limits.lower, "joint lower limit");
    require_finite(limits.upper, "joint upper limit");
    require(limits.lower <= limits.upper, "joint limits (lower, upper)", "in order", Vec2{limits.lower, limits.upper});
}

void check_part(const JointSpring& spring) {
    require_positive(spring.hertz, "spring hertz");
    require_not_negative(spring.damping_ratio, "spring damping_ratio");
}

void check_part(const AngularMotor& motor) {
    require_finite(motor.speed, "motor speed");
    require_not_negative(motor.max_torque, "motor max_torque");
}

void check_part(const LinearMotor& motor) {
    require_finite(motor.speed, "motor speed");
    require_not_negative(motor.max_force, "motor max_force");
}

template <class Part>
void check_part(const std::optional<Part>& part) {
    if (part) check_part(*part);
}

void check_axis(Vec2 axis) {
    const float size = length(axis);
    require(std::isfinite(size) && size > 0.0f, "joint axis", "finite and longer than 0", axis);
}

// A strength may be infinite.
void check_strength(float value, const char* what) { require(value > 0.0f, what, "greater than 0", value); }

void check_anchors(Vec2 a, Vec2 b) {
    require(is_finite(a), "joint anchor_a", "finite", a);
    require(is_finite(b), "joint anchor_b", "finite", b);
}

template <class Def>
void check_common(const Def& def) {
    if constexpr (requires { def.anchor_a; }) check_anchors(def.anchor_a, def.anchor_b);
    check_strength(def.break_force, "joint break_force");
    check_strength(def.break_torque, "joint break_torque");
    if constexpr (requires { def.reference_angle; }) require_finite(def.reference_angle, "joint reference_angle");
    if constexpr (requires { def.axis_a; }) check_axis(def.axis_a);
    if constexpr (requires { def.limits; }) check_part(def.limits);
    if constexpr (requires { def.motor; }) check_part(def.motor);
    if constexpr (requires { def.spring; }) check_part(def.spring);
}

struct Checker {
    void operator()(const FilterJointDef&) const {}
    void operator()(const RevoluteJointDef& def) const { check_common(def); }
    void operator()(const PrismaticJointDef& def) const { check_common(def); }
    void operator()(const WheelJointDef& def) const { check_common(def); }
    void operator()(const DistanceJointDef& def) const {
        check_common(def);
        require_positive(def.length, "joint length");
        if (def.limits) require_not_negative(def.limits->lower, "least length of a joint");
        if (def.motor && !def.spring && !def.limits)
            throw std::invalid_argument("motor of a distance joint needs a spring or limits: a rod does not move");
    }
    void operator()(const WeldJointDef& def) const {
        check_common(def);
        check_part(def.linear_spring);
        check_part(def.angular_spring);
    }
    void operator()(const MotorJointDef& def) const {
        check_common(def);
        require(is_finite(def.velocity), "joint velocity", "finite", def.velocity);
        require_finite(def.angular_velocity, "joint angular_velocity");
        require_not_negative(def.max_force, "joint max_force");
        require_not_negative(def.max_torque, "joint max_torque");
    }
    void operator()(const MouseJointDef& def) const {
        check_common(def);
        require_not_negative(def.max_force, "joint max_force");
    }
    void operator()(const PulleyJointDef& def) const {
        check_common(def);
        check_point(def.ground_anchor_a);
        check_point(def.ground_anchor_b);
        require_positive(def.length, "joint length");
        require_positive(def.ratio, "joint ratio");
    }
    void operator()(const GearJointDef& def) const {
        check_common(def);
        require(std::isfinite(def.ratio) && def.ratio != 0.0f, "joint ratio", "finite and not 0", def.ratio);
    }
};

}  // namespace

void check(const JointDef& def) { std::visit(Checker{}, def); }

}  // namespace tumble
