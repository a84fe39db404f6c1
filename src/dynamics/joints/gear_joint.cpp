#include "dynamics/joints/gear_joint.hpp"

namespace tumble {

void GearJoint::prepare(const BodyStore& bodies) {
    const double a = side_a_.start_step(bodies, bodies_.first), b = side_b_.start_step(bodies, bodies_.second);
    slip_ += a + static_cast<double>(bodies_.ratio) * b;
}

CoupledRow GearJoint::row(std::span<const SolverBody> bodies) const {
    return {side_a_.row(bodies_.first, bodies), side_b_.row(bodies_.second, bodies)};
}

float GearJoint::measure_error(std::span<const SolverBody> bodies) {
    const float moved =
        side_a_.change_in_step(bodies_.first, bodies) + bodies_.ratio * side_b_.change_in_step(bodies_.second, bodies);
    return static_cast<float>(slip_) + moved;
}

void GearJoint::update_rows(std::span<const SolverBody> bodies) {
    row_ = row(bodies);
    error_ = measure_error(bodies);
}

void GearJoint::warm_start(std::span<SolverBody> bodies) const { apply_row(bodies_, row_, impulse_, bodies); }

void GearJoint::solve(const JointContext& context, bool use_bias, std::span<SolverBody> bodies) {
    if (!context.iterates_equalities) return;
    solve_equality(bodies_, row_, context.equality_softness(use_bias), error_, impulse_, bodies);
}

// Keeps the slip. The last measurements are kept only if the new definition measures the same motions.
void GearJoint::take_over(const GearJoint& old) {
    if (bodies_.ratio == old.bodies_.ratio && side_a_.measures_same_as(old.side_a_) &&
        side_b_.measures_same_as(old.side_b_)) {
        side_a_ = old.side_a_;
        side_b_ = old.side_b_;
    }
    slip_ = old.slip_;
    impulse_ = old.impulse_;
}

}  // namespace tumble
