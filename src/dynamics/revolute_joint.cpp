#include "dynamics/revolute_joint.hpp"

namespace tumble {

namespace {

// Solves K x = b for the symmetric matrix of a point constraint,
//   K = (1/m_A + 1/m_B) 1 + sum over both bodies of 1/I (r_y^2, -r_x r_y; -r_x r_y, r_x^2);
// zero if neither body can give way.
Vec2 solve_point(const JointBodies& bodies, Vec2 arm_a, Vec2 arm_b, Vec2 b) {
    const float linear = bodies.inv_mass_a + bodies.inv_mass_b;
    const float ia = bodies.inv_inertia_a, ib = bodies.inv_inertia_b;
    const float k11 = linear + ia * arm_a.y * arm_a.y + ib * arm_b.y * arm_b.y;
    const float k12 = -ia * arm_a.x * arm_a.y - ib * arm_b.x * arm_b.y;
    const float k22 = linear + ia * arm_a.x * arm_a.x + ib * arm_b.x * arm_b.x;
    const float determinant = k11 * k22 - k12 * k12;
    const float scale = determinant > 0.0f ? 1.0f / determinant : 0.0f;
    return {scale * (k22 * b.x - k12 * b.y), scale * (k11 * b.y - k12 * b.x)};
}

}  // namespace

void RevoluteJoint::prepare(const BodyStore& bodies) {
    bodies_ = JointBodies::make(bodies.frames[def_.body_a.index], def_.anchor_a, bodies.frames[def_.body_b.index],
                                def_.anchor_b);
}

void RevoluteJoint::warm_start(std::span<SolverBody> bodies) const {
    bodies_.apply(impulse_, bodies_.current_arm_a(bodies), bodies_.current_arm_b(bodies), bodies);
}

void RevoluteJoint::solve(const JointContext& context, bool use_bias, std::span<SolverBody> bodies) {
    const Vec2 arm_a = bodies_.current_arm_a(bodies), arm_b = bodies_.current_arm_b(bodies);
    const Softness softness = use_bias ? context.softness : Softness{};
    const Vec2 bias = softness.bias_rate * bodies_.current_separation(bodies);
    const Vec2 velocity = velocity_at(bodies[bodies_.b], arm_b) - velocity_at(bodies[bodies_.a], arm_a);
    const Vec2 rigid = solve_point(bodies_, arm_a, arm_b, velocity + bias);
    const Vec2 impulse = -softness.mass_scale * rigid - softness.impulse_scale * impulse_;
    impulse_ += impulse;
    bodies_.apply(impulse, arm_a, arm_b, bodies);
}

}  // namespace tumble
