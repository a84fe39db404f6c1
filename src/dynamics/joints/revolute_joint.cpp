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

void RevoluteJoint::warm_start(std::span<SolverBody> bodies) const {
    if (!drive_.is_idle()) apply_row(bodies_, kAngularRow, drive_.impulse(), bodies);
    PointBlock::make(bodies_, bodies).apply(bodies_, impulse_, bodies);
}

void RevoluteJoint::solve(const JointContext& context, bool use_bias, std::span<SolverBody> bodies) {
    if (!drive_.is_idle())
        drive_.solve(bodies_, kAngularRow, AnglePosition{angle_, bodies_, bodies}, 0.0f, context, use_bias, bodies);
    if (!context.iterates_equalities) return;
    if (is_lone_ && use_bias) return solve_lone_point(bodies_, context, impulse_, bodies);
    solve_block(bodies_, PointBlock::make(bodies_, bodies), context.equality_softness(use_bias),
                bodies_.current_separation(bodies), impulse_, bodies);
}

void RevoluteJoint::take_over(const RevoluteJoint& old) {
    angle_ = old.angle_;
    impulse_ = old.impulse_;
    drive_.take_over(old.drive_);
}

}  // namespace tumble
