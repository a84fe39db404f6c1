// Joints are made of rows. A row is one direction of relative motion, linear, angular or both: it measures a velocity,
// an impulse acts along it, and a constraint is solved on it.
//
// The velocity of a row is axis . (v_B - v_A) + turn_b w_B - turn_a w_A, and an impulse P changes v_B by P axis / m_B,
// w_B by P turn_b / I_B, and A's the other way. The formulas are in terms of rows alone, whatever the joint.
#pragma once

#include <algorithm>
#include <span>

#include "dynamics/rows/joint_bodies.hpp"

namespace tumble {

struct JointRow {
    Vec2 axis;  // world; zero for a pure rotation
    float turn_a = 0.0f;
    float turn_b = 0.0f;
};

inline JointRow operator+(const JointRow& a, const JointRow& b) {
    return {a.axis + b.axis, a.turn_a + b.turn_a, a.turn_b + b.turn_b};
}
inline JointRow operator*(float factor, const JointRow& row) {
    return {factor * row.axis, factor * row.turn_a, factor * row.turn_b};
}

// The relative rotation of the bodies.
inline constexpr JointRow kTurningRow{{}, 1.0f, 1.0f};

// The motion of B's anchor against A's along an axis fixed in the world for the moment.
inline JointRow point_row(Vec2 axis, Vec2 arm_a, Vec2 arm_b) { return {axis, cross(arm_a, axis), cross(arm_b, axis)}; }

// How B's anchor moves along an axis that turns with A: seen from A, the anchor is at A's own plus the separation.
inline JointRow sliding_row(Vec2 axis, Vec2 arm_a, Vec2 separation, Vec2 arm_b) {
    return point_row(axis, arm_a + separation, arm_b);
}

inline float row_velocity(const JointBodies& joint, const JointRow& row, std::span<const SolverBody> all) {
    const SolverBody& a = all[joint.a];
    const SolverBody& b = all[joint.b];
    return dot(row.axis, b.velocity - a.velocity) + row.turn_b * b.angular_velocity - row.turn_a * a.angular_velocity;
}

inline void apply_row(const JointBodies& joint, const JointRow& row, float impulse, std::span<SolverBody> all) {
    SolverBody& a = all[joint.a];
    SolverBody& b = all[joint.b];
    a.velocity -= impulse * scaled(joint.inv_mass_a, row.axis);
    a.angular_velocity -= joint.inv_inertia_a * impulse * row.turn_a;
    b.velocity += impulse * scaled(joint.inv_mass_b, row.axis);
    b.angular_velocity += joint.inv_inertia_b * impulse * row.turn_b;
}

// What a unit impulse along one row does to the velocity of another (or its own: the inverse effective mass).
inline float row_response(const JointBodies& joint, const JointRow& row, const JointRow& other) {
    return dot(scaled(joint.inv_mass_a + joint.inv_mass_b, row.axis), other.axis) +
           joint.inv_inertia_a * row.turn_a * other.turn_a + joint.inv_inertia_b * row.turn_b * other.turn_b;
}

// Near a dead point a row gives way by a small part of what its bodies would without their locks: the response that is
// small, and the inverse of a response damped by it, r / (r^2 + e^2) [Wampler 1986].
inline float dead_response(const JointBodies& joint, const JointRow& row) {
    return kDeadPoint * joint.locked_mass * length_sq(row.axis);
}
inline float damped_inverse(float response, float damping) {
    return response / (response * response + damping * damping);
}

// Effective mass; 0 if neither body can give way.
inline float row_mass(const JointBodies& joint, const JointRow& row) {
    const float response = row_response(joint, row, row);
    if (!(response > 0.0f)) return 0.0f;
    if (joint.locked_mass == 0.0f) return 1.0f / response;
    return damped_inverse(response, dead_response(joint, row));
}

// What follows is for rows of any kind: of two bodies, or coupled ones (coupled_row.hpp).

// The change of the accumulated impulse that takes `speed` away, softened; not yet applied.
template <class Bodies, class Row>
float row_change(const Bodies& joint, const Row& row, const Softness& softness, float speed, float impulse) {
    return -softness.mass_scale * row_mass(joint, row) * speed - softness.impulse_scale * impulse;
}

// Drives `error` to zero, rigidly or softly. `impulse` accumulates.
template <class Bodies, class Row>
void solve_equality(const Bodies& joint, const Row& row, const Softness& softness, float error, float& impulse,
                    std::span<SolverBody> all) {
    const float speed = row_velocity(joint, row, all) + softness.bias_rate * error;
    const float change = row_change(joint, row, softness, speed, impulse);
    impulse += change;
    apply_row(joint, row, change, all);
}

// Brings the velocity of a row to -bias, softened, with an accumulated impulse of at most `max_impulse`.
inline void solve_bounded_row(const JointBodies& joint, const JointRow& row, const Softness& softness, float bias,
                              float max_impulse, float& impulse, std::span<SolverBody> all) {
    const float speed = row_velocity(joint, row, all) + bias;
    const float wanted = impulse + row_change(joint, row, softness, speed, impulse);
    const float total = std::clamp(wanted, -max_impulse, max_impulse);
    apply_row(joint, row, total - impulse, all);
    impulse = total;
}

// Lets the row move by `room` more in the direction against `side` (+1 or -1), and pushes back by `side` if there is
// none: room left is speculative, as between shapes.
inline void solve_limit(const JointBodies& joint, const JointRow& row, float side, float room,
                        const JointContext& context, bool use_bias, float& impulse, std::span<SolverBody> all) {
    const bool is_free = room > 0.0f;
    const Softness softness = !is_free && use_bias ? context.softness : Softness{};
    const float bias = is_free ? room * context.inv_h : softness.bias_rate * room;
    const float speed = side * row_velocity(joint, row, all) + bias;
    const float total = std::max(impulse + row_change(joint, row, softness, speed, impulse), 0.0f);
    apply_row(joint, row, side * (total - impulse), all);
    impulse = total;
}

}  // namespace tumble
