// A constraint row: one scalar direction of the relative motion of two bodies, linear, angular or both. A joint solves
// each of its rows, or two of them as a block (joint_block.hpp).
//
// The velocity of a row is axis . (v_B - v_A) + angular_b w_B - angular_a w_A: its Jacobian is (-axis, -angular_a,
// axis, angular_b). An impulse P along it changes v_B by P axis / m_B and w_B by P angular_b / I_B, and v_A and w_A by
// the opposite. With a unit axis a linear row has m/s and N s; the angular row has rad/s and N m s.
#pragma once

#include <algorithm>
#include <span>

#include "debug/check.hpp"
#include "dynamics/rows/joint_bodies.hpp"

namespace tumble {

struct JointRow {
    Vec2 axis;  // world, unit or a sum of such; zero for a pure rotation
    float angular_a = 0.0f;
    float angular_b = 0.0f;
    Vec2 arm_a, arm_b;  // from the centres of mass to where the impulse acts, m; the direct solver alone uses them
};

inline JointRow operator+(const JointRow& a, const JointRow& b) {
    return {a.axis + b.axis, a.angular_a + b.angular_a, a.angular_b + b.angular_b, a.arm_a, a.arm_b};
}
inline JointRow operator*(float factor, const JointRow& row) {
    return {factor * row.axis, factor * row.angular_a, factor * row.angular_b, row.arm_a, row.arm_b};
}

// The relative rotation of the bodies: w_B - w_A. As a type of its own it neither reads nor writes linear velocities.
struct AngularRow {
    constexpr operator JointRow() const { return {{}, 1.0f, 1.0f, {}, {}}; }
};
inline constexpr AngularRow kAngularRow;

// The velocity of B's anchor relative to A's along an axis that does not rotate.
inline JointRow point_row(Vec2 axis, Vec2 arm_a, Vec2 arm_b) {
    return {axis, cross(arm_a, axis), cross(arm_b, axis), arm_a, arm_b};
}

// The velocity of B's anchor along an axis that rotates with A: relative to the point of A where B's anchor is, which
// is A's anchor plus the separation.
inline JointRow sliding_row(Vec2 axis, Vec2 arm_a, Vec2 separation, Vec2 arm_b) {
    return point_row(axis, arm_a + separation, arm_b);
}

inline float row_velocity(const JointBodies& joint, const JointRow& row, std::span<const SolverBody> all) {
    TUMBLE_CHECK(joint.a < all.size());
    TUMBLE_CHECK(joint.b < all.size());
    const SolverBody& a = all[joint.a];
    const SolverBody& b = all[joint.b];
    return dot(row.axis, b.velocity - a.velocity) + row.angular_b * b.angular_velocity -
           row.angular_a * a.angular_velocity;
}

inline void apply_row(const JointBodies& joint, const JointRow& row, float impulse, std::span<SolverBody> all) {
    TUMBLE_CHECK(joint.a < all.size());
    TUMBLE_CHECK(joint.b < all.size());
    SolverBody& a = all[joint.a];
    SolverBody& b = all[joint.b];
    a.velocity -= impulse * scaled(joint.inv_mass_a, row.axis);
    a.angular_velocity -= joint.inv_inertia_a * impulse * row.angular_a;
    b.velocity += impulse * scaled(joint.inv_mass_b, row.axis);
    b.angular_velocity += joint.inv_inertia_b * impulse * row.angular_b;
}

inline float row_velocity(const JointBodies& joint, AngularRow, std::span<const SolverBody> all) {
    TUMBLE_CHECK(joint.a < all.size());
    TUMBLE_CHECK(joint.b < all.size());
    return all[joint.b].angular_velocity - all[joint.a].angular_velocity;
}

inline void apply_row(const JointBodies& joint, AngularRow, float impulse, std::span<SolverBody> all) {
    TUMBLE_CHECK(joint.a < all.size());
    TUMBLE_CHECK(joint.b < all.size());
    all[joint.a].angular_velocity -= joint.inv_inertia_a * impulse;
    all[joint.b].angular_velocity += joint.inv_inertia_b * impulse;
}

// The change of the velocity of `other` by a unit impulse along `row`; of a row itself its inverse effective mass K.
inline float row_response(const JointBodies& joint, const JointRow& row, const JointRow& other) {
    return dot(scaled(joint.inv_mass_a + joint.inv_mass_b, row.axis), other.axis) +
           joint.inv_inertia_a * row.angular_a * other.angular_a +
           joint.inv_inertia_b * row.angular_b * other.angular_b;
}

// Near a dead point the locks of the bodies leave a row almost no response r, and 1 / r would grow without bound. There
// the effective mass is damped to r / (r^2 + e^2) [Wampler 1986], with e a small part of the response without locks.
inline float dead_response(const JointBodies& joint, const JointRow& row) {
    return kDeadPoint * joint.locked_mass * length_sq(row.axis);
}
inline float damped_inverse(float response, float damping) {
    return response / (response * response + damping * damping);
}

// Effective mass, kg or kg m^2; 0 if neither body can move along the row.
inline float row_mass(const JointBodies& joint, const JointRow& row) {
    const float response = row_response(joint, row, row);
    if (!(response > 0.0f)) return 0.0f;
    if (joint.locked_mass == 0.0f) return 1.0f / response;
    return damped_inverse(response, dead_response(joint, row));
}

inline float row_mass(const JointBodies& joint, AngularRow) {
    const float response = joint.inv_inertia_a + joint.inv_inertia_b;
    return response > 0.0f ? 1.0f / response : 0.0f;
}

// row_change() and solve_equality() are for rows of two bodies and for coupled rows (coupled_row.hpp).

// The change of the accumulated `impulse` that removes `speed` (velocity plus bias) from the row, softened. It is not
// applied yet.
template <class Bodies, class Row>
float row_change(const Bodies& joint, const Row& row, const Softness& softness, float speed, float impulse) {
    return -softness.mass_scale * row_mass(joint, row) * speed - softness.impulse_scale * impulse;
}

// Solves the equality constraint error = 0 (m or rad) once, and adds to the accumulated `impulse`. With
// softness.bias_rate = 0 only the velocity is brought to 0.
template <class Bodies, class Row>
void solve_equality(const Bodies& joint, const Row& row, const Softness& softness, float error, float& impulse,
                    std::span<SolverBody> all) {
    const float speed = row_velocity(joint, row, all) + softness.bias_rate * error;
    const float change = row_change(joint, row, softness, speed, impulse);
    impulse += change;
    apply_row(joint, row, change, all);
}

// Brings the velocity of a row to -bias, softened, with an accumulated impulse of at most max_impulse in size.
template <class Row>
void solve_bounded_row(const JointBodies& joint, const Row& row, const Softness& softness, float bias,
                       float max_impulse, float& impulse, std::span<SolverBody> all) {
    const float speed = row_velocity(joint, row, all) + bias;
    TUMBLE_CHECK(max_impulse >= 0.0f);
    const float wanted = impulse + row_change(joint, row, softness, speed, impulse);
    const float total = std::clamp(wanted, -max_impulse, max_impulse);
    apply_row(joint, row, total - impulse, all);
    impulse = total;
}

// Solves the limit gap >= 0, where `gap` (m or rad) is the distance left to the limit, negative beyond it, and grows
// along the row times `side` (+1 for a lower limit, -1 for an upper one). A positive gap is speculative, as between
// shapes: the impulse, which is never negative, stops only what would cross the limit in this sub-step.
template <class Row>
void solve_limit(const JointBodies& joint, const Row& row, float side, float gap, const JointContext& context,
                 bool use_bias, float& impulse, std::span<SolverBody> all) {
    TUMBLE_CHECK((side == 1.0f || side == -1.0f));
    const bool is_free = gap > 0.0f;
    const Softness softness = !is_free && use_bias ? context.softness : Softness{};
    const float bias = is_free ? gap * context.inv_h : softness.bias_rate * gap;
    const float speed = side * row_velocity(joint, row, all) + bias;
    const float total = std::max(impulse + row_change(joint, row, softness, speed, impulse), 0.0f);
    apply_row(joint, row, side * (total - impulse), all);
    impulse = total;
}

// False if solve_limit() would change nothing, as the row does not cross the limit in this sub-step. `gap` may be a
// lower bound of the gap.
template <class Row>
bool may_reach_limit(const JointBodies& joint, const Row& row, float side, float gap, const JointContext& context,
                     float impulse, std::span<const SolverBody> all) {
    return impulse != 0.0f || !(gap > 0.0f) || !(gap * context.inv_h + side * row_velocity(joint, row, all) >= 0.0f);
}

}  // namespace tumble
