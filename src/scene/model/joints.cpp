// Anchors in world coordinates become local anchors of both bodies. Missing values are measured in the poses at load.
#include "scene/model/joints.hpp"

#include <cmath>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "scene/model/degrees.hpp"

namespace tumble::scene {

namespace {

std::pair<Vec2, Vec2> local_anchors(const SceneJoint& joint, const Pose& a, const Pose& b) {
    if (joint.anchors) return {to_float(joint.anchors->first), to_float(joint.anchors->second)};
    const DVec2 world = joint.anchor.value_or(DVec2{});
    return {to_float(inverse_transform_point(a, world)), to_float(inverse_transform_point(b, world))};
}

std::optional<JointSpring> make_spring(const std::optional<SceneJointSpring>& spring) {
    if (!spring) return std::nullopt;
    return JointSpring{static_cast<float>(spring->hertz), static_cast<float>(spring->damping_ratio)};
}

std::optional<JointLimits> make_limits(const std::optional<SceneInterval>& limits, double unit) {
    if (!limits) return std::nullopt;
    return JointLimits{static_cast<float>(limits->lower * unit), static_cast<float>(limits->upper * unit)};
}

std::optional<AngularMotor> make_angular_motor(const std::optional<SceneJointMotor>& motor) {
    if (!motor) return std::nullopt;
    return AngularMotor{static_cast<float>(motor->speed * kRadians), static_cast<float>(motor->max_torque.value_or(0))};
}

std::optional<LinearMotor> make_linear_motor(const std::optional<SceneJointMotor>& motor) {
    if (!motor) return std::nullopt;
    return LinearMotor{static_cast<float>(motor->speed), static_cast<float>(motor->max_force.value_or(0))};
}

float make_strength(const std::optional<double>& strength) {
    return strength ? static_cast<float>(*strength) : kUnbreakable;
}

// The axis in A's coordinates. Given with `anchors` it is already, else it is a direction of the world at load.
Vec2 local_axis(const SceneJoint& joint, const Pose& a) {
    const DVec2 axis = joint.axis.value_or(DVec2{1.0, 0.0});
    const Vec2 local = to_float(joint.anchors ? axis : inverse_rotate(a.rotation, axis));
    if (!(length(local) > 0.0f)) throw std::invalid_argument("the axis of a joint must be longer than 0");
    return local;
}

// Makes the definition of one joint. common() fills in the members that several types have, by name.
class JointMaker {
public:
    JointMaker(const SceneJoint& joint, const PlacedBody& a, const PlacedBody& b) : joint_(joint), a_(a), b_(b) {}

    RevoluteJointDef revolute() const {
        auto def = common<RevoluteJointDef>();
        def.limits = make_limits(joint_.limits, kRadians);
        def.motor = make_angular_motor(joint_.motor);
        def.spring = make_spring(joint_.spring);
        return def;
    }

    DistanceJointDef distance() const {
        auto def = common<DistanceJointDef>();
        const double at_load = length(transform_point(b_.pose, def.anchor_b) - transform_point(a_.pose, def.anchor_a));
        def.length = static_cast<float>(joint_.length.value_or(at_load));
        if (!(def.length > 0.0f)) throw std::invalid_argument("a distance joint needs anchors that are apart");
        def.limits = make_limits(joint_.limits, 1.0);
        def.motor = make_linear_motor(joint_.motor);
        def.spring = make_spring(joint_.spring);
        if (def.motor && !def.limits && !def.spring)
            throw std::invalid_argument(
                "the motor of a rigid distance joint cannot move it: add 'limits' or a 'spring'");
        return def;
    }

    PrismaticJointDef prismatic() const {
        auto def = common<PrismaticJointDef>();
        def.limits = make_limits(joint_.limits, 1.0);
        def.motor = make_linear_motor(joint_.motor);
        def.spring = make_spring(joint_.spring);
        return def;
    }

    WeldJointDef weld() const {
        auto def = common<WeldJointDef>();
        def.linear_spring = make_spring(joint_.spring);
        def.angular_spring = make_spring(joint_.angular_spring);
        return def;
    }

    WheelJointDef wheel() const {
        auto def = common<WheelJointDef>();
        def.limits = make_limits(joint_.limits, 1.0);
        def.motor = make_angular_motor(joint_.motor);
        def.spring = make_spring(joint_.spring);
        return def;
    }

    MotorJointDef motor() const {
        auto def = common<MotorJointDef>();
        def.velocity = to_float(joint_.velocity.value_or(DVec2{}));
        def.angular_velocity = static_cast<float>(joint_.angular_velocity.value_or(0.0) * kRadians);
        def.max_force = static_cast<float>(joint_.max_force.value_or(0.0));
        def.max_torque = static_cast<float>(joint_.max_torque.value_or(0.0));
        def.spring = make_spring(joint_.spring);
        return def;
    }

    MouseJointDef mouse() const {
        auto def = common<MouseJointDef>();
        def.spring = make_spring(joint_.spring).value_or(def.spring);
        def.max_force = static_cast<float>(joint_.max_force.value_or(0.0));
        return def;
    }

    PulleyJointDef pulley() const {
        auto def = common<PulleyJointDef>();
        std::tie(def.ground_anchor_a, def.ground_anchor_b) = joint_.ground_anchors.value_or(std::pair<DVec2, DVec2>{});
        def.ratio = static_cast<float>(joint_.ratio.value_or(1.0));
        const double a = length(transform_point(a_.pose, def.anchor_a) - def.ground_anchor_a);
        const double b = length(transform_point(b_.pose, def.anchor_b) - def.ground_anchor_b);
        def.length = static_cast<float>(joint_.length.value_or(a + double{def.ratio} * b));
        if (!(def.length > 0.0f)) throw std::invalid_argument("a pulley needs anchors that are apart from its wheels");
        return def;
    }

private:
    template <class Def>
    Def common() const {
        Def def;
        std::tie(def.anchor_a, def.anchor_b) = local_anchors(joint_, a_.pose, b_.pose);
        def.break_force = make_strength(joint_.break_force);
        def.break_torque = make_strength(joint_.break_torque);
        def.collide_connected = joint_.collide_connected;
        if constexpr (requires { def.axis_a; }) def.axis_a = local_axis(joint_, a_.pose);
        if constexpr (requires { def.reference_angle; }) {
            // A joint measures its angle up to whole turns: the reference is reduced to [-180, 180] degrees.
            const double degrees = std::remainder(joint_.reference_angle.value_or(b_.angle - a_.angle), 360.0);
            def.reference_angle = static_cast<float>(degrees * kRadians);
        }
        return def;
    }

    const SceneJoint& joint_;
    const PlacedBody& a_;
    const PlacedBody& b_;
};

}  // namespace

JointDef make_joint(const SceneJoint& joint, const PlacedBody& a, const PlacedBody& b) {
    const JointMaker maker(joint, a, b);
    switch (joint.type) {
        case SceneJointType::revolute: return maker.revolute();
        case SceneJointType::distance: return maker.distance();
        case SceneJointType::prismatic: return maker.prismatic();
        case SceneJointType::weld: return maker.weld();
        case SceneJointType::wheel: return maker.wheel();
        case SceneJointType::motor: return maker.motor();
        case SceneJointType::mouse: return maker.mouse();
        case SceneJointType::pulley: return maker.pulley();
        case SceneJointType::filter: return FilterJointDef{};
        case SceneJointType::gear: break;
    }
    throw std::invalid_argument("a gear connects joints, not bodies");
}

GearJointDef make_gear(const SceneJoint& gear) {
    GearJointDef def;
    def.ratio = static_cast<float>(gear.ratio.value_or(1.0));
    def.break_force = make_strength(gear.break_force);
    def.break_torque = make_strength(gear.break_torque);
    def.collide_connected = gear.collide_connected;
    return def;
}

}  // namespace tumble::scene
