// A block: two constraint rows of a joint that are solved together. A point constraint is one, and so are the two rows
// of a slider across its axis and against rotation.
//
// A block has the relative velocities of its two rows, applies impulses along them, and has the symmetric 2 x 2 matrix
// K of inverse effective masses. In velocities, errors and impulses (Vec2) x belongs to the first row, y to the second.
#pragma once

#include <span>

#include "debug/check.hpp"
#include "dynamics/rows/joint_row.hpp"

namespace tumble {

// Rounding dominates a determinant below this part of K11 K22: its error is 2^-24 of each product. For an arm r at 45
// degrees the determinant is about 4 I / (m r^2) of the products. The threshold, where its relative error is 1 %, is an
// arm of 630 radii of gyration: a joint that has been torn far apart.
inline constexpr float kSingular = 1e-5f;

// K11, K12 = K21 and K22: the change of the velocity of each row by a unit impulse along each.
struct BlockMatrix {
    float k11, k12, k22;

    float determinant() const { return k11 * k22 - k12 * k12; }

    bool is_singular() const { return !(determinant() > kSingular * k11 * k22); }
};

// The point constraint: B's anchor coincides with A's. Its rows are along the axes of the world:
//   K = (1/m_A + 1/m_B) 1 + sum over both bodies of 1/I (r_y^2, -r_x r_y; -r_x r_y, r_x^2).
// Its functions are inlined into the two passes over hinges, which are the inner loop of worlds with joints: called,
// they cost 3 % of the instructions of such a world.
struct PointBlock {
    Vec2 arm_a, arm_b;  // from the centres of mass to the anchors, m

    static PointBlock make(const JointBodies& joint, std::span<const SolverBody> all) {
        return {joint.current_arm_a(all), joint.current_arm_b(all)};
    }

    // From A's anchor to B's, m. To be called at the deltas of make().
    [[gnu::always_inline]] Vec2 separation(const JointBodies& joint, std::span<const SolverBody> all) const {
        return joint.separation_of(arm_a, arm_b, all);
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

    [[gnu::always_inline]] Vec2 velocity(const JointBodies& joint, std::span<const SolverBody> all) const {
        TUMBLE_CHECK(joint.a < all.size());
        TUMBLE_CHECK(joint.b < all.size());
        return velocity_at(all[joint.b], arm_b) - velocity_at(all[joint.a], arm_a);
    }

    [[gnu::always_inline]] void apply(const JointBodies& joint, Vec2 impulse, std::span<SolverBody> all) const {
        TUMBLE_CHECK(joint.a < all.size());
        TUMBLE_CHECK(joint.b < all.size());
        SolverBody& a = all[joint.a];
        SolverBody& b = all[joint.b];
        a.velocity -= scaled(joint.inv_mass_a, impulse);
        a.angular_velocity -= joint.inv_inertia_a * cross(arm_a, impulse);
        b.velocity += scaled(joint.inv_mass_b, impulse);
        b.angular_velocity += joint.inv_inertia_b * cross(arm_b, impulse);
    }
};

// A block of any two rows.
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

// The impulses along the rows of a block that cancel the change of their velocities by a unit impulse along another
// row: - K^-1 k. Zero if the block is solved row by row.
inline Vec2 block_compensation(const JointBodies& joint, const RowBlock& block, const JointRow& row) {
    const BlockMatrix matrix = block.matrix(joint);
    if (joint.may_be_singular() || matrix.is_singular()) return {};
    const float first = row_response(joint, block.first, row), second = row_response(joint, block.second, row);
    const float scale = 1.0f / matrix.determinant();
    return {scale * (matrix.k12 * second - matrix.k22 * first), scale * (matrix.k12 * first - matrix.k11 * second)};
}

// row_change() for a block whose matrix is not singular.
inline Vec2 block_change(const BlockMatrix& k, const Softness& softness, Vec2 speed, Vec2 impulse) {
    TUMBLE_CHECK(k.determinant() > 0.0f);
    const float scale = softness.mass_scale / k.determinant();
    const Vec2 soft{scale * (k.k22 * speed.x - k.k12 * speed.y), scale * (k.k11 * speed.y - k.k12 * speed.x)};
    return -soft - softness.impulse_scale * impulse;
}

// solve_equality() for each row of a block. A function of its own, as few joints need it.
template <class Block>
[[gnu::noinline]] void solve_row_by_row(const JointBodies& joint, const Block& block, const Softness& softness,
                                        Vec2 error, Vec2& impulse, std::span<SolverBody> all) {
    solve_equality(joint, block.first_row(), softness, error.x, impulse.x, all);
    solve_equality(joint, block.second_row(), softness, error.y, impulse.y, all);
}

// solve_equality() for a block; solves row by row where the matrix cannot be inverted.
template <class Block>
[[gnu::always_inline]] inline void solve_block(const JointBodies& joint, const Block& block, const Softness& softness,
                                               Vec2 error, Vec2& impulse, std::span<SolverBody> all) {
    const BlockMatrix matrix = block.matrix(joint);
    if (joint.may_be_singular() || matrix.is_singular())
        return solve_row_by_row(joint, block, softness, error, impulse, all);
    const Vec2 speed = block.velocity(joint, all) + softness.bias_rate * error;
    const Vec2 change = block_change(matrix, softness, speed, impulse);
    impulse += change;
    block.apply(joint, change, all);
}

// solve_bounded_row() for a block, with a bound on the length of the accumulated impulse.
template <class Block>
void solve_bounded_block(const JointBodies& joint, const Block& block, const Softness& softness, Vec2 bias,
                         float max_impulse, Vec2& impulse, std::span<SolverBody> all) {
    TUMBLE_CHECK(max_impulse >= 0.0f);
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
