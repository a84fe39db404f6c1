#include "dynamics/joints/revolute_joint.hpp"

#include "dynamics/rows/lone_joint.hpp"

namespace tumble {

void RevoluteJoint::prepare(const BodyStore& bodies) {
    TUMBLE_CHECK(body_a_ < bodies.frames.size());
    TUMBLE_CHECK(body_b_ < bodies.frames.size());
    const BodyFrame& a = bodies.frames[body_a_];
    const BodyFrame& b = bodies.frames[body_b_];
    bodies_ = JointBodies::make(a, anchor_a_, b, anchor_b_);
    if (drive_.needs_value()) angle_.prepare(a, b, reference_angle_);
}

void RevoluteJoint::update_rows(std::span<const SolverBody> bodies) {
    block_ = PointBlock::make(bodies_, bodies);
    if (drive_.needs_value()) range_ = angle_.range(bodies_, bodies);
}

void RevoluteJoint::warm_start(std::span<SolverBody> bodies) const {
    if (!drive_.is_idle()) apply_row(bodies_, kAngularRow, drive_.impulse(), bodies);
    block_.apply(bodies_, impulse_, bodies);
}

void RevoluteJoint::solve(const JointContext& context, bool use_bias, std::span<SolverBody> bodies) {
    if (!drive_.is_idle()) solve_drive(context, use_bias, bodies);
    if (!context.iterates_equalities) return;
    if (is_lone_ && use_bias) return solve_lone_point(bodies_, block_, context, impulse_, bodies);
    // The relaxing pass has no bias: it needs no error.
    const Vec2 error = use_bias ? block_.separation(bodies_, bodies) : Vec2{};
    solve_block(bodies_, block_, context.equality_softness(use_bias), error, impulse_, bodies);
}

// A function of its own, so that a hinge without a drive does not save the registers that it needs.
[[gnu::noinline]] void RevoluteJoint::solve_drive(const JointContext& context, bool use_bias,
                                                  std::span<SolverBody> bodies) {
    const AnglePosition position{angle_, bodies_, bodies, range_};
    drive_.solve(bodies_, kAngularRow, position, 0.0f, context, use_bias, bodies);
}

bool RevoluteJoint::fits_lanes(const BodyStore& bodies) const {
    const BodyFrame &a = bodies.frames[body_a_], &b = bodies.frames[body_b_];
    return !JointBodies::make(a, anchor_a_, b, anchor_b_).may_be_singular();
}

void RevoluteJoint::take_over(const RevoluteJoint& old) {
    angle_ = old.angle_;
    impulse_ = old.impulse_;
    drive_.take_over(old.drive_);
}

}  // namespace tumble
