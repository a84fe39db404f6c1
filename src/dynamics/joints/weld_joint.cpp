#include "dynamics/joints/weld_joint.hpp"

namespace tumble {

namespace {

Softness softness_of(const std::optional<JointSpring>& spring, const JointContext& context, bool use_bias) {
    return spring ? spring_softness(*spring, context.h) : context.equality_softness(use_bias);
}

// Springs are solved in the pass with bias only, as in JointDrive.
bool is_solved(const std::optional<JointSpring>& spring, const JointContext& context, bool use_bias) {
    return spring ? use_bias : context.iterates_equalities;
}

}  // namespace

void WeldJoint::prepare(const BodyStore& bodies) {
    TUMBLE_CHECK(def_.body_a.index < bodies.frames.size());
    TUMBLE_CHECK(def_.body_b.index < bodies.frames.size());
    const BodyFrame& a = bodies.frames[def_.body_a.index];
    const BodyFrame& b = bodies.frames[def_.body_b.index];
    bodies_ = JointBodies::make(a, def_.anchor_a, b, def_.anchor_b);
    angle_.prepare(a, b, def_.reference_angle);
}

void WeldJoint::update_rows(std::span<const SolverBody> bodies) { block_ = PointBlock::make(bodies_, bodies); }

void WeldJoint::warm_start(std::span<SolverBody> bodies) const {
    apply_row(bodies_, kAngularRow, angular_impulse_, bodies);
    block_.apply(bodies_, impulse_, bodies);
}

void WeldJoint::solve(const JointContext& context, bool use_bias, std::span<SolverBody> bodies) {
    // The relaxing pass has no bias: it needs no errors.
    if (is_solved(def_.angular_spring, context, use_bias)) {
        const float error = use_bias ? angle_.now(bodies_, bodies) : 0.0f;
        solve_equality(bodies_, kAngularRow, softness_of(def_.angular_spring, context, use_bias), error,
                       angular_impulse_, bodies);
    }
    if (is_solved(def_.linear_spring, context, use_bias)) {
        const Vec2 error = use_bias ? block_.separation(bodies_, bodies) : Vec2{};
        solve_block(bodies_, block_, softness_of(def_.linear_spring, context, use_bias), error, impulse_, bodies);
    }
}

void WeldJoint::take_over(const WeldJoint& old) {
    angle_ = old.angle_;
    impulse_ = old.impulse_;
    angular_impulse_ = old.angular_impulse_;
}

}  // namespace tumble
