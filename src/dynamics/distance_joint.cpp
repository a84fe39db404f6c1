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

}  // namespace

void DistanceJoint::prepare(const BodyStore& bodies) {
    bodies_ = JointBodies::make(bodies.frames[def_.body_a.index], def_.anchor_a, bodies.frames[def_.body_b.index],
                                def_.anchor_b);
    axis_ = line_along(bodies_.center_difference + bodies_.arm_b - bodies_.arm_a).axis;
}

void DistanceJoint::warm_start(std::span<SolverBody> bodies) const {
    const Line line = line_along(bodies_.current_separation(bodies));
    bodies_.apply(impulse_ * line.axis, bodies_.current_arm_a(bodies), bodies_.current_arm_b(bodies), bodies);
}

void DistanceJoint::solve(const JointContext& context, bool use_bias, std::span<SolverBody> bodies) {
    const Vec2 arm_a = bodies_.current_arm_a(bodies), arm_b = bodies_.current_arm_b(bodies);
    const Line line = line_along(bodies_.current_separation(bodies));
    const float across_a = cross(arm_a, line.axis), across_b = cross(arm_b, line.axis);
    const float inverse_mass = bodies_.inv_mass_a + bodies_.inv_mass_b + bodies_.inv_inertia_a * across_a * across_a +
                               bodies_.inv_inertia_b * across_b * across_b;
    if (!(inverse_mass > 0.0f)) return;
    const Softness softness = use_bias ? context.softness : Softness{};
    const float bias = softness.bias_rate * (line.length - def_.length);
    const Vec2 velocity = velocity_at(bodies[bodies_.b], arm_b) - velocity_at(bodies[bodies_.a], arm_a);
    const float impulse =
        -softness.mass_scale * (dot(velocity, line.axis) + bias) / inverse_mass - softness.impulse_scale * impulse_;
    impulse_ += impulse;
    bodies_.apply(impulse * line.axis, arm_a, arm_b, bodies);
}

}  // namespace tumble
