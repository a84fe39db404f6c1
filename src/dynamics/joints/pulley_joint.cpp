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

void PulleyJoint::warm_start(std::span<SolverBody> bodies) const {
    const JointLine a = JointLine::now(bodies_.first, bodies), b = JointLine::now(bodies_.second, bodies);
    apply_row(bodies_, CoupledRow{a.row(bodies_.first, bodies), b.row(bodies_.second, bodies)}, impulse_, bodies);
}

void PulleyJoint::solve(const JointContext& context, bool use_bias, std::span<SolverBody> bodies) {
    if (!context.iterates_equalities) return;
    const JointLine a = JointLine::now(bodies_.first, bodies), b = JointLine::now(bodies_.second, bodies);
    const CoupledRow row{a.row(bodies_.first, bodies), b.row(bodies_.second, bodies)};
    solve_equality(bodies_, row, context.equality_softness(use_bias), a.length + def_.ratio * b.length - def_.length,
                   impulse_, bodies);
}

}  // namespace tumble
