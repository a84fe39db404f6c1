#include "dynamics/joints/distance_joint.hpp"

#include "dynamics/rows/lone_joint.hpp"

namespace tumble {

void DistanceJoint::prepare(const BodyStore& bodies) {
    TUMBLE_CHECK(def_.body_a.index < bodies.frames.size());
    TUMBLE_CHECK(def_.body_b.index < bodies.frames.size());
    bodies_ = JointBodies::make(bodies.frames[def_.body_a.index], def_.anchor_a, bodies.frames[def_.body_b.index],
                                def_.anchor_b);
    line_ = JointLine::along(bodies_.separation_at_start());
}

void DistanceJoint::update_rows(std::span<const SolverBody> bodies) { now_ = LineRow::make(bodies_, bodies); }

void DistanceJoint::warm_start(std::span<SolverBody> bodies) const { apply_row(bodies_, now_.row, impulse(), bodies); }

void DistanceJoint::solve(const JointContext& context, bool use_bias, std::span<SolverBody> bodies) {
    drive_.solve(bodies_, now_.row, KnownPosition{now_.line.length}, def_.length, context, use_bias, bodies);
    if (!is_rod() || !context.iterates_equalities) return;
    const float error = now_.line.length - def_.length;
    if (is_lone_ && use_bias) return solve_lone_rod(bodies_, now_.line, now_.row, error, context, rod_impulse_, bodies);
    solve_equality(bodies_, now_.row, context.equality_softness(use_bias), error, rod_impulse_, bodies);
}

void DistanceJoint::take_over(const DistanceJoint& old) {
    if (is_rod()) rod_impulse_ = old.rod_impulse_;
    drive_.take_over(old.drive_);
}

}  // namespace tumble
