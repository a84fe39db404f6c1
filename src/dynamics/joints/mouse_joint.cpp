#include "dynamics/joints/mouse_joint.hpp"

namespace tumble {

void MouseJoint::prepare(const BodyStore& bodies) {
    TUMBLE_CHECK(def_.body_a.index < bodies.frames.size());
    TUMBLE_CHECK(def_.body_b.index < bodies.frames.size());
    bodies_ = JointBodies::make(bodies.frames[def_.body_a.index], def_.anchor_a, bodies.frames[def_.body_b.index],
                                def_.anchor_b);
}

void MouseJoint::update_rows(std::span<const SolverBody> bodies) { block_ = PointBlock::make(bodies_, bodies); }

void MouseJoint::warm_start(std::span<SolverBody> bodies) const { block_.apply(bodies_, impulse_, bodies); }

void MouseJoint::solve(const JointContext& context, bool use_bias, std::span<SolverBody> bodies) {
    if (!use_bias) return;  // springs are solved in the pass with bias only, as in JointDrive
    const Softness softness = spring_softness(def_.spring, context.h);
    solve_bounded_block(bodies_, block_, softness, softness.bias_rate * block_.separation(bodies_, bodies),
                        context.h * def_.max_force, impulse_, bodies);
}

}  // namespace tumble
