// Two rows of a joint solved at once: what holds a point, or a slider across its axis and against turning.
//
// A block knows the relative velocities of its two rows, what impulses along them do, and the symmetric matrix of its
// responses. The components of speeds, errors and impulses belong to the rows.
#pragma once

#include <span>

#include "dynamics/rows/joint_row.hpp"

namespace tumble {

// Inverse effective masses: K11, K12 = K21, K22.
struct BlockMatrix {
    float k11, k12, k22;

    float determinant() const { return k11 * k22 - k12 * k12; }

    // True if rounding has eaten the determinant, known to 2^-24 of each product. For an arm r at 45 degrees it is
    // about 4 I / (m r^2) of them: 1e-5, where it is known to a hundredth, is an arm of 630 radii of gyration, as when
    // a joint has been torn far apart.
    bool is_singular() const { return !(determinant() > 1e-5f * k11 * k22); }
};

// Holds B's anchor on A's, along the axes of the world:
//   K = (1/m_A + 1/m_B) 1 + sum over both bodies of 1/I (r_y^2, -r_x r_y; -r_x r_y, r_x^2).
struct PointBlock {
    Vec2 arm_a, arm_b;

    static PointBlock make(const JointBodies& joint, std::span<const SolverBody> all) {
        return {joint.current_arm_a(all), joint.current_arm_b(all)};
    }

    JointRow first_row() const { return point_row({1.0f, 0.0f}, arm_a, arm_b); }
    JointRow second_row() const { return point_row({0.0f, 1.0f}, arm_a, arm_b); }

    BlockMatrix matrix(const JointBodies& joint) const {
        const Vec2 linear = joint.inv_mass_a + joint.inv_mass_b;
        const float ia = joint.inv_inertia_a, ib = joint.inv_inertia_b;
        return {linear.x + ia * arm_a.y * arm_a.y + ib * arm_b.y * arm_b.y,
                -ia * arm_a.x * arm_a.y - ib * arm_b.x * arm_b.y,
                linear.y + ia * arm_a.x * arm_a.x + ib * arm_b.x * arm_b.x};
    }

    Vec2 velocity(const JointBodies& joint, std::span<const SolverBody> all) const {
        return velocity_at(all[joint.b], arm_b) - velocity_at(all[joint.a], arm_a);
    }

    void apply(const JointBodies& joint, Vec2 impulse, std::span<SolverBody> all) const {
        SolverBody& a = all[joint.a];
        SolverBody& b = all[joint.b];
        a.velocity -= scaled(joint.inv_mass_a, impulse);
        a.angular_velocity -= joint.inv_inertia_a * cross(arm_a, impulse);
        b.velocity += scaled(joint.inv_mass_b, impulse);
        b.angular_velocity += joint.inv_inertia_b * cross(arm_b, impulse);
    }
};

// Any two rows.
struct RowBlock {
    JointRow first, second;

    const JointRow& first_row() const { return first; }
    const JointRow& second_row() const { return second; }

    BlockMatrix matrix(const JointBodies& joint) const {
        return {row_response(joint, first, first), row_response(joint, first, second),
                row_response(joint, second, second)};
    }

    Vec2 velocity(const JointBodies& joint, std::span<const SolverBody> all) const {
        return {row_velocity(joint, first, all), row_velocity(joint, second, all)};
    }

    void apply(const JointBodies& joint, Vec2 impulse, std::span<SolverBody> all) const {
        apply_row(joint, first, impulse.x, all);
        apply_row(joint, second, impulse.y, all);
    }
};

// The impulses along the rows of a block that undo what a unit impulse along another row does to them: - K^-1 k.
inline Vec2 block_answer(const JointBodies& joint, const RowBlock& block, const JointRow& row) {
    const BlockMatrix matrix = block.matrix(joint);
    if (joint.may_be_singular() || matrix.is_singular()) return {};
    const float first = row_response(joint, block.first, row), second = row_response(joint, block.second, row);
    const float scale = 1.0f / matrix.determinant();
    return {scale * (matrix.k12 * second - matrix.k22 * first), scale * (matrix.k12 * first - matrix.k11 * second)};
}

// As row_change(), for a matrix that is not singular.
inline Vec2 block_change(const BlockMatrix& k, const Softness& softness, Vec2 speed, Vec2 impulse) {
    const float scale = softness.mass_scale / k.determinant();
    const Vec2 soft{scale * (k.k22 * speed.x - k.k12 * speed.y), scale * (k.k11 * speed.y - k.k12 * speed.x)};
    return -soft - softness.impulse_scale * impulse;
}

// As solve_equality(); row by row where the matrix cannot be inverted.
template <class Block>
void solve_block(const JointBodies& joint, const Block& block, const Softness& softness, Vec2 error, Vec2& impulse,
                 std::span<SolverBody> all) {
    const BlockMatrix matrix = block.matrix(joint);
    if (joint.may_be_singular() || matrix.is_singular()) {
        solve_equality(joint, block.first_row(), softness, error.x, impulse.x, all);
        solve_equality(joint, block.second_row(), softness, error.y, impulse.y, all);
        return;
    }
    const Vec2 speed = block.velocity(joint, all) + softness.bias_rate * error;
    const Vec2 change = block_change(matrix, softness, speed, impulse);
    impulse += change;
    block.apply(joint, change, all);
}

// As solve_bounded_row(), with a bound on the length of the accumulated impulse.
template <class Block>
void solve_bounded_block(const JointBodies& joint, const Block& block, const Softness& softness, Vec2 bias,
                         float max_impulse, Vec2& impulse, std::span<SolverBody> all) {
    const Vec2 speed = block.velocity(joint, all) + bias;
    const BlockMatrix matrix = block.matrix(joint);
    Vec2 total = impulse;
    if (joint.may_be_singular() || matrix.is_singular()) {
        total.x += row_change(joint, block.first_row(), softness, speed.x, impulse.x);
        total.y += row_change(joint, block.second_row(), softness, speed.y, impulse.y);
    } else {
        total += block_change(matrix, softness, speed, impulse);
    }
    const float size = length(total);
    if (size > max_impulse) total = (max_impulse / size) * total;
    block.apply(joint, total - impulse, all);
    impulse = total;
}

}  // namespace tumble
