#include "reference/box2d_v3/v3_joint_plan.hpp"

#include <cmath>

#include "tumble/math.hpp"

namespace tumble::reference {

namespace {

namespace v3 = box2d_v3;

v3::Place joint_frame(Vec2 anchor, double angle) {
    const Rotation q = make_rotation(angle);
    return {anchor.x, anchor.y, q.c, q.s};
}

double angle_of(Vec2 axis) { return std::atan2(double{axis.y}, double{axis.x}); }

// A joint angle of 0 is the reference angle, and the axis is that of x: both are in the rotations of the frames.
template <class Def>
v3::JointPlan framed(v3::JointKind kind, const Def& joint, double axis_angle, double reference_angle) {
    v3::JointPlan plan;
    plan.kind = kind;
    plan.frame_a = joint_frame(joint.anchor_a, axis_angle);
    plan.frame_b = joint_frame(joint.anchor_b, axis_angle - reference_angle);
    plan.collides = joint.collide_connected;
    return plan;
}

double strength(const AngularMotor& motor) { return double{motor.max_torque}; }
double strength(const LinearMotor& motor) { return double{motor.max_force}; }

template <class Def>
v3::JointPlan with_motion(v3::JointPlan plan, const Def& joint) {
    if (joint.limits) {
        plan.has_limits = true;
        plan.lower = joint.limits->lower;
        plan.upper = joint.limits->upper;
    }
    if (joint.motor) {
        plan.has_motor = true;
        plan.motor_speed = joint.motor->speed;
        plan.motor_strength = static_cast<float>(strength(*joint.motor));
    }
    if (joint.spring) {
        plan.has_spring = true;
        plan.hertz = joint.spring->hertz;
        plan.damping_ratio = joint.spring->damping_ratio;
    }
    return plan;
}

std::optional<v3::JointPlan> plan_of(const RevoluteJointDef& joint) {
    return with_motion(framed(v3::JointKind::revolute, joint, 0.0, double{joint.reference_angle}), joint);
}
std::optional<v3::JointPlan> plan_of(const PrismaticJointDef& joint) {
    return with_motion(framed(v3::JointKind::prismatic, joint, angle_of(joint.axis_a), double{joint.reference_angle}),
                       joint);
}
std::optional<v3::JointPlan> plan_of(const WheelJointDef& joint) {
    return with_motion(framed(v3::JointKind::wheel, joint, angle_of(joint.axis_a), 0.0), joint);
}
std::optional<v3::JointPlan> plan_of(const DistanceJointDef& joint) {
    v3::JointPlan plan = with_motion(framed(v3::JointKind::distance, joint, 0.0, 0.0), joint);
    plan.length = joint.length;
    return plan;
}
std::optional<v3::JointPlan> plan_of(const WeldJointDef& joint) {
    v3::JointPlan plan = framed(v3::JointKind::weld, joint, 0.0, double{joint.reference_angle});
    if (joint.linear_spring) {
        plan.hertz = joint.linear_spring->hertz;
        plan.damping_ratio = joint.linear_spring->damping_ratio;
    }
    if (joint.angular_spring) {
        plan.angular_hertz = joint.angular_spring->hertz;
        plan.angular_damping_ratio = joint.angular_spring->damping_ratio;
    }
    return plan;
}
std::optional<v3::JointPlan> plan_of(const auto&) { return std::nullopt; }

bool joint_breaks(const auto& joint) { return joint.break_force != kUnbreakable || joint.break_torque != kUnbreakable; }
bool joint_breaks(const FilterJointDef&) { return false; }

}  // namespace

std::optional<v3::JointPlan> v3_joint_plan(const JointDef& joint) {
    return std::visit([](const auto& def) { return joint_breaks(def) ? std::optional<v3::JointPlan>{} : plan_of(def); },
                      joint);
}

}  // namespace tumble::reference
