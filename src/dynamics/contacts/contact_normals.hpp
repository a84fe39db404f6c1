// The normal impulses of a block: both points of each contact at once.
#pragma once

#include "dynamics/contacts/block_state.hpp"

namespace tumble {

// The linear complementarity problem for the normal impulses x of two points: A x + q >= 0, x >= 0, and for each point
// one of the two is zero. A is the matrix of inverse effective masses with a softened diagonal, q the residual velocity
// without impulses.
struct NormalProblem {
    Lanes a11, a22, a12;
    Lanes q1, q2;
};

// The exact solution, by trying which points get an impulse: both, the first alone, the second alone [Catto 2007,
// "Block solver"]. Solving one point after the other would tip every box a little, and stacks would lean.
TUMBLE_LANE_FUNCTION void solve_both(const NormalProblem& p, Lanes& x1, Lanes& x2) {
    const Lanes zero = Lanes::Zero();
    const Lanes scale = Lanes::Ones() / (p.a11 * p.a22 - p.a12 * p.a12);
    const Lanes both1 = scale * (p.a12 * p.q2 - p.a22 * p.q1);
    const Lanes both2 = scale * (p.a12 * p.q1 - p.a11 * p.q2);
    const Lanes first = larger(-p.q1 / p.a11, zero);
    const Lanes second = larger(-p.q2 / p.a22, zero);
    const Lanes residual2 = p.a12 * first + p.q2;
    const Lanes lone1 = select_less(residual2, zero, zero, first);
    const Lanes lone2 = select_less(residual2, zero, second, zero);
    const Lanes least = smaller(both1, both2);
    x1 = select_less(least, zero, lone1, both1);
    x2 = select_less(least, zero, lone2, both2);
}

// The power x . v of impulses at both points.
TUMBLE_LANE_FUNCTION Lanes power(const ContactBlock& block, const Lanes& impulse1, const Lanes& impulse2,
                                 const BlockState& state) {
    return impulse1 * normal_velocity(block.points[0], state) + impulse2 * normal_velocity(block.points[1], state);
}

// Applies impulses at both points. With restitution it also adds up the absorbed energy: an impulse does the work that
// it would do at the mean of the velocities before and after.
TUMBLE_LANE_FUNCTION void push_normals(ContactBlock& block, const Lanes& impulse1, const Lanes& impulse2,
                                       BlockState& state) {
    if (block.has_restitution) block.extras->absorbed -= 0.5f * power(block, impulse1, impulse2, state);
    apply_normal(block, block.points[0], impulse1, state);
    apply_normal(block, block.points[1], impulse2, state);
    if (block.has_restitution) block.extras->absorbed -= 0.5f * power(block, impulse1, impulse2, state);
}

// One point's row of the problem: its diagonal, softened, and its residual without the other point's impulse.
struct NormalRow {
    Lanes diagonal;
    Lanes residual;
};

// The change of the points' impulses that solves both rows.
TUMBLE_LANE_FUNCTION void find_changes(const ContactBlock& block, const Lanes& coupling, const NormalRow& first,
                                       const NormalRow& second, Lanes& change1, Lanes& change2) {
    const Lanes& old1 = block.points[0].normal_impulse;
    const Lanes& old2 = block.points[1].normal_impulse;
    const Lanes q1 = first.residual - coupling * old2, q2 = second.residual - coupling * old1;
    Lanes impulse1, impulse2;
    solve_both({first.diagonal, second.diagonal, coupling, q1, q2}, impulse1, impulse2);
    change1 = impulse1 - old1;
    change2 = impulse2 - old2;
}

TUMBLE_LANE_FUNCTION void change_normals(ContactBlock& block, const Lanes& change1, const Lanes& change2,
                                         BlockState& state) {
    block.points[0].normal_impulse += change1;
    block.points[1].normal_impulse += change2;
    push_normals(block, change1, change2, state);
}

TUMBLE_LANE_FUNCTION void solve_normals(ContactBlock& block, const NormalRow& first, const NormalRow& second,
                                        BlockState& state) {
    Lanes change1, change2;
    find_changes(block, block.coupling, first, second, change1, change2);
    change_normals(block, change1, change2, state);
}

}  // namespace tumble
