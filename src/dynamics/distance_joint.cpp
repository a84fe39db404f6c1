#include "dynamics/distance_joint.hpp"

namespace tumble {

namespace {

struct Line {
    Vec2 axis;  // unit, or zero if the length is
    float length = 0.0f;
};

Line line_along(Vec2 separation) {
    const float size = length(separation);
    return size > 0.0f ? Line{(1.0f / size) * separation, size} : Line{};
}

JointRow row_along(const Line& line, const JointBodies& joint, std::span<const SolverBody> all) {
    return point_row(line.axis, joint.current_arm_a(all), joint.current_arm_b(all));
}

}  // namespace

void DistanceJoint::prepare(const BodyStore& bodies) {
    bodies_ = JointBodies::make(bodies.frames[def_.body_a.index], def_.anchor_a, bodies.frames[def_.body_b.index],
                                def_.anchor_b);
    const Line line = line_along(bodies_.center_difference + bodies_.arm_b - bodies_.arm_a);
    axis_ = line.axis;
    length_ = line.length;
}

void DistanceJoint::warm_start(std::span<SolverBody> bodies) const {
    const Line line = line_along(bodies_.current_separation(bodies));
    apply_row(bodies_, row_along(line, bodies_, bodies), impulse(), bodies);
}

void DistanceJoint::solve(const JointContext& context, bool use_bias, std::span<SolverBody> bodies) {
    const Line line = line_along(bodies_.current_separation(bodies));
    const JointRow row = row_along(line, bodies_, bodies);
    drive_.solve(bodies_, row, line.length, def_.length, context, use_bias, bodies);
    if (is_rod())
        solve_equality(bodies_, row, context.equality_softness(use_bias), line.length - def_.length, rod_impulse_,
                       bodies);
}

void DistanceJoint::take_over(const DistanceJoint& old) {
    if (is_rod()) rod_impulse_ = old.rod_impulse_;
    drive_.take_over(old.drive_);
}

}  // namespace tumble
