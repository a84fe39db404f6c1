#include "dynamics/joints/prismatic_joint.hpp"

namespace tumble {

void PrismaticJoint::prepare(const BodyStore& bodies) {
    TUMBLE_CHECK(def_.body_a.index < bodies.frames.size());
    TUMBLE_CHECK(def_.body_b.index < bodies.frames.size());
    const BodyFrame& a = bodies.frames[def_.body_a.index];
    const BodyFrame& b = bodies.frames[def_.body_b.index];
    bodies_ = JointBodies::make(a, def_.anchor_a, b, def_.anchor_b);
    axis_ = rotate(a.pose.rotation, unit(def_.axis_a));
    angle_.prepare(a, b, def_.reference_angle);
}

PrismaticJoint::Rail PrismaticJoint::rail(std::span<const SolverBody> bodies) const {
    const Vec2 axis = rotate(bodies[bodies_.a].delta_rotation, axis_);
    const Vec2 arm_a = bodies_.current_arm_a(bodies), arm_b = bodies_.current_arm_b(bodies);
    const Vec2 separation = bodies_.separation_of(arm_a, arm_b, bodies);
    const JointRow along = sliding_row(axis, arm_a, separation, arm_b);
    const RowBlock constrained{sliding_row(perp(axis), arm_a, separation, arm_b), kAngularRow};
    const Vec2 compensation = drive_.is_idle() ? Vec2{} : block_compensation(bodies_, constrained, along);
    return {axis, separation, constrained, compensation,
            along + compensation.x * constrained.first + compensation.y * constrained.second};
}

Vec2 PrismaticJoint::constrained_error(const Rail& now, std::span<const SolverBody> bodies) const {
    return {dot(perp(now.axis), now.separation), angle_.now(bodies_, bodies)};
}

void PrismaticJoint::update_rows(std::span<const SolverBody> bodies) { rail_ = rail(bodies); }

void PrismaticJoint::warm_start(std::span<SolverBody> bodies) const {
    apply_row(bodies_, rail_.free, drive_.impulse(), bodies);
    rail_.constrained.apply(bodies_, impulse_, bodies);
}

void PrismaticJoint::solve(const JointContext& context, bool use_bias, std::span<SolverBody> bodies) {
    drive_.solve(bodies_, rail_.free, KnownPosition{dot(rail_.axis, rail_.separation)}, 0.0f, context, use_bias,
                 bodies);
    if (!context.iterates_equalities) return;
    // The relaxing pass has no bias: it needs no error.
    const Vec2 error = use_bias ? constrained_error(rail_, bodies) : Vec2{};
    solve_block(bodies_, rail_.constrained, context.equality_softness(use_bias), error, impulse_, bodies);
}

JointReaction PrismaticJoint::reaction(float inv_h) const {
    const Vec2 constrained = impulse_ + drive_.impulse() * rail_.compensation;
    return {inv_h * (drive_.impulse() * axis_ + constrained.x * perp(axis_)), inv_h * constrained.y};
}

void PrismaticJoint::take_over(const PrismaticJoint& old) {
    angle_ = old.angle_;
    impulse_ = old.impulse_;
    drive_.take_over(old.drive_);
}

}  // namespace tumble
