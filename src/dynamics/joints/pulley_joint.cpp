#include "dynamics/joints/pulley_joint.hpp"

namespace tumble {

namespace {

// One side of the rope: a static body at the wheel, and the body that hangs on it.
JointBodies side(DVec2 wheel, const BodyFrame& body, Vec2 anchor) {
    BodyFrame world;
    world.center = wheel;
    return JointBodies::make(world, {}, body, anchor);
}

}  // namespace

void PulleyJoint::prepare(const BodyStore& bodies) {
    TUMBLE_CHECK(def_.body_a.index < bodies.frames.size());
    TUMBLE_CHECK(def_.body_b.index < bodies.frames.size());
    bodies_ = {side(def_.ground_anchor_a, bodies.frames[def_.body_a.index], def_.anchor_a),
               side(def_.ground_anchor_b, bodies.frames[def_.body_b.index], def_.anchor_b), def_.ratio};
    line_a_ = JointLine::along(bodies_.first.separation_at_start());
    line_b_ = JointLine::along(bodies_.second.separation_at_start());
}

PulleyJoint::Rope PulleyJoint::rope(std::span<const SolverBody> bodies) const {
    const LineRow a = LineRow::make(bodies_.first, bodies), b = LineRow::make(bodies_.second, bodies);
    return {{a.row, b.row}, a.line.length + def_.ratio * b.line.length - def_.length};
}

void PulleyJoint::update_rows(std::span<const SolverBody> bodies) { rope_ = rope(bodies); }

void PulleyJoint::warm_start(std::span<SolverBody> bodies) const { apply_row(bodies_, rope_.row, impulse_, bodies); }

void PulleyJoint::solve(const JointContext& context, bool use_bias, std::span<SolverBody> bodies) {
    if (!context.iterates_equalities) return;
    solve_equality(bodies_, rope_.row, context.equality_softness(use_bias), rope_.error, impulse_, bodies);
}

}  // namespace tumble
