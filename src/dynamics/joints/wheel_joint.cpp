#include "dynamics/joints/wheel_joint.hpp"

namespace tumble {

void WheelJoint::prepare(const BodyStore& bodies) {
    TUMBLE_CHECK(def_.body_a.index < bodies.frames.size());
    TUMBLE_CHECK(def_.body_b.index < bodies.frames.size());
    const BodyFrame& a = bodies.frames[def_.body_a.index];
    bodies_ = JointBodies::make(a, def_.anchor_a, bodies.frames[def_.body_b.index], def_.anchor_b);
    axis_ = rotate(a.pose.rotation, unit(def_.axis_a));
}

WheelJoint::Strut WheelJoint::strut(std::span<const SolverBody> bodies) const {
    const Vec2 axis = rotate(bodies[bodies_.a].delta_rotation, axis_);
    const Vec2 arm_a = bodies_.current_arm_a(bodies), arm_b = bodies_.current_arm_b(bodies);
    const Vec2 separation = bodies_.separation_of(arm_a, arm_b, bodies);
    return {axis, separation, sliding_row(axis, arm_a, separation, arm_b),
            sliding_row(perp(axis), arm_a, separation, arm_b)};
}

void WheelJoint::update_rows(std::span<const SolverBody> bodies) { strut_ = strut(bodies); }

void WheelJoint::warm_start(std::span<SolverBody> bodies) const {
    apply_row(bodies_, strut_.along, suspension_.impulse(), bodies);
    apply_row(bodies_, kAngularRow, axle_.impulse(), bodies);
    apply_row(bodies_, strut_.across, across_impulse_, bodies);
}

void WheelJoint::solve(const JointContext& context, bool use_bias, std::span<SolverBody> bodies) {
    axle_.solve(bodies_, kAngularRow, KnownPosition{}, 0.0f, context, use_bias, bodies);
    suspension_.solve(bodies_, strut_.along, KnownPosition{dot(strut_.axis, strut_.separation)}, 0.0f, context,
                      use_bias, bodies);
    if (!context.iterates_equalities) return;
    solve_equality(bodies_, strut_.across, context.equality_softness(use_bias),
                   dot(perp(strut_.axis), strut_.separation), across_impulse_, bodies);
}

void WheelJoint::take_over(const WheelJoint& old) {
    suspension_.take_over(old.suspension_);
    axle_.take_over(old.axle_);
    across_impulse_ = old.across_impulse_;
}

}  // namespace tumble
