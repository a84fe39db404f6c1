// A hinge or rod that is the only joint with rows of its bodies: filter joints have none. Solving its rows once solves
// the whole system of joints, as src/dynamics/direct does: pendulums keep period and amplitude.
//
// In the pass with bias, first the velocities satisfy the rows. Then the bodies get the velocities along the chords of
// their paths: those at which the rows hold when the sub-step ends. The relaxing pass projects the velocities
// (../direct/JOINT_SYSTEM.md, section 1). Both rows are rigid.
#pragma once

#include <span>

#include "dynamics/rows/joint_block.hpp"
#include "dynamics/rows/joint_line.hpp"

namespace tumble {

// The mean velocity of a turning arm in the sub-step, less that at its start. By the turn q = h w the arm becomes c arm
// + s perp(arm), so that this is ((c - 1) arm + (s - q) perp(arm)) / h.
inline Vec2 chord_bend(const SolverBody& body, Vec2 arm, const JointContext& context) {
    if (body.angular_velocity == 0.0f) return {};
    const float turn = context.h * body.angular_velocity;
    const Rotation rotation = small_rotation(turn);
    return context.inv_h * ((rotation.c - 1.0f) * arm + (rotation.s - turn) * perp(arm));
}

// Of the error, the chord removes the part that a soft row removes in a sub-step. A function of its own, so that other
// hinges do not save the registers that it needs.
[[gnu::noinline]] inline void solve_lone_point(const JointBodies& joint, const PointBlock& block,
                                               const JointContext& context, Vec2& impulse, std::span<SolverBody> all) {
    solve_block(joint, block, Softness{}, {}, impulse, all);
    const Vec2 bend = chord_bend(all[joint.b], block.arm_b, context) - chord_bend(all[joint.a], block.arm_a, context);
    const Softness rigid{context.softness.bias_rate, 1.0f, 0.0f};
    solve_block(joint, block, rigid, block.separation(joint, all) + (1.0f / rigid.bias_rate) * bend, impulse, all);
}

// `row` is that of the line, `error` the line's length less that of the rod, m. With the separation s and the mean
// velocity u of its ends, the mean velocity of the row is (|s + h u| - |s|) / h = u . (2 s + h u) / (|s + h u| + |s|).
inline void solve_lone_rod(const JointBodies& joint, const JointLine& line, const JointRow& row, float error,
                           const JointContext& context, float& impulse, std::span<SolverBody> all) {
    const float mass = row_mass(joint, row);
    const auto stop = [&](float speed) {
        impulse -= mass * speed;
        apply_row(joint, row, -mass * speed, all);
    };
    stop(row_velocity(joint, row, all));
    const SolverBody& a = all[joint.a];
    const SolverBody& b = all[joint.b];
    const Vec2 mean = velocity_at(b, row.arm_b) + chord_bend(b, row.arm_b, context) - velocity_at(a, row.arm_a) -
                      chord_bend(a, row.arm_a, context);
    const Vec2 now = line.length * line.axis, ahead = now + context.h * mean;
    const float sum = length(ahead) + line.length;
    if (sum > 0.0f) stop(dot(mean, now + ahead) / sum + context.softness.bias_rate * error);
}

}  // namespace tumble
