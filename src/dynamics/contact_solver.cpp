// The contact kernel: projected Gauss-Seidel over blocks of eight contacts, soft in the biased pass, rigid otherwise.
#include <algorithm>

#include "dynamics/block_state.hpp"

namespace tumble {

namespace {

// What the normal impulses x of the two points are to achieve: A x + q >= 0 with x >= 0, one of them zero for each
// point. A is the matrix of inverse effective masses, softened on its diagonal, q the residual without impulses.
struct NormalProblem {
    Lanes a11, a22, a12;
    Lanes q1, q2;
};

// The exact solution for two points by trying who carries: both, the first alone, the second alone [Catto 2007,
// "Block solver"]. One after the other they would tip every box a little, which seeds the lean of a stack.
TUMBLE_LANE_FUNCTION void solve_both(const NormalProblem& p, Lanes& x1, Lanes& x2) {
    const Lanes zero = Lanes::Zero();
    const Lanes scale = Lanes::Ones() / (p.a11 * p.a22 - p.a12 * p.a12);
    const Lanes both1 = scale * (p.a12 * p.q2 - p.a22 * p.q1);
    const Lanes both2 = scale * (p.a12 * p.q1 - p.a11 * p.q2);
    const Lanes first = (-p.q1 / p.a11).max(zero);
    const Lanes second = (-p.q2 / p.a22).max(zero);
    const Lanes residual2 = p.a12 * first + p.q2;
    const Lanes lone1 = select_less(residual2, zero, zero, first);
    const Lanes lone2 = select_less(residual2, zero, second, zero);
    const Lanes least = both1.min(both2);
    x1 = select_less(least, zero, lone1, both1);
    x2 = select_less(least, zero, lone2, both2);
}

TUMBLE_LANE_FUNCTION void apply_normals(ContactBlock& block, const NormalProblem& problem, BlockState& state) {
    ContactBlockPoint& first = block.points[0];
    ContactBlockPoint& second = block.points[1];
    Lanes impulse1, impulse2;
    solve_both(problem, impulse1, impulse2);
    const Lanes change1 = impulse1 - first.normal_impulse, change2 = impulse2 - second.normal_impulse;
    first.normal_impulse = impulse1;
    second.normal_impulse = impulse2;
    apply_normal(block, first, change1, state);
    apply_normal(block, second, change2, state);
}

// One point's share of the problem: its diagonal, softened, and its residual without the other's impulse.
struct NormalRow {
    Lanes diagonal;
    Lanes residual;
};

// What a soft contact keeps of its impulse, if it is taken back less than a spring would for the load that it carries,
// and more for what is new: all of it at most, where sub-steps are shorter than 0.8 ms.
TUMBLE_LANE_FUNCTION Lanes kept_impulse(const ContactBlock& block, const ContactBlockPoint& point) {
    const float back = block.softness.impulse_scale, fresh_back = std::min(kFreshSoftness * back, 1.0f);
    const float keeps_fresh = 1.0f - fresh_back, keeps_more_carried = fresh_back - kCarriedSoftness * back;
    return keeps_fresh * point.normal_impulse + keeps_more_carried * point.carried.min(point.normal_impulse);
}

// Gaps are speculative: rigid, and closed in one sub-step at the fastest. Overlap is removed softly, as by an implicit
// spring and damper whose mass scale divides the diagonal, and no faster than the push-out speed.
TUMBLE_LANE_FUNCTION NormalRow make_soft_row(const ContactBlock& block, const ContactBlockPoint& point,
                                             const Lanes& shift, float inv_h, float push_out_speed,
                                             const BlockState& state) {
    const Lanes zero = Lanes::Zero();
    const Lanes separation = current_separation(block, point, shift, state);
    const Lanes gap = separation.max(zero), overlap = separation.min(zero);
    const float max_push = push_out_speed / block.softness.mass_scale;  // before the mass scale
    const Lanes bias = gap * inv_h + (overlap * block.softness.bias_rate).max(-max_push);
    const Lanes soft = point.inverse_mass * (1.0f / block.softness.mass_scale);
    const Lanes diagonal = select_less(zero, separation, point.inverse_mass, soft);
    const Lanes kept = select_less(zero, separation, point.normal_impulse, kept_impulse(block, point));
    return {diagonal, normal_velocity(point, state) + bias - diagonal * kept};
}

TUMBLE_LANE_FUNCTION NormalRow make_rigid_row(const ContactBlock& block, const ContactBlockPoint& point,
                                              const Lanes& shift, float inv_h, const BlockState& state) {
    const Lanes gap = current_separation(block, point, shift, state).max(Lanes::Zero());
    return {point.inverse_mass,
            normal_velocity(point, state) + gap * inv_h - point.inverse_mass * point.normal_impulse};
}

TUMBLE_LANE_FUNCTION void solve_normals(ContactBlock& block, const Lanes& coupling, const NormalRow& first,
                                        const NormalRow& second, BlockState& state) {
    const Lanes q1 = first.residual - coupling * block.points[1].normal_impulse;
    const Lanes q2 = second.residual - coupling * block.points[0].normal_impulse;
    apply_normals(block, {first.diagonal, second.diagonal, coupling, q1, q2}, state);
}

// Coulomb friction against the normal impulse; a belt's surface moves by itself.
TUMBLE_LANE_FUNCTION void solve_friction(const ContactBlock& block, ContactBlockPoint& point, BlockState& state) {
    Lanes slip = tangent_velocity(point, state);
    if (block.has_tangent_speed) slip += block.tangent_speed;
    const Lanes old_impulse = point.tangent_impulse;
    const Lanes wanted = old_impulse - point.tangent_mass * slip;
    point.tangent_impulse = clamp_magnitude(wanted, block.friction * point.normal_impulse);
    const Lanes change = point.tangent_impulse - old_impulse;
    point.applied_tangent += point.tangent_impulse;
    apply_tangent(block, point, change, state);
}

// A torque against rolling, at most resistance times the normal impulse.
TUMBLE_LANE_FUNCTION void solve_rolling(ContactBlock& block, BlockState& state) {
    const Lanes roll = state.b.angular_velocity - state.a.angular_velocity;
    const Lanes normal_impulse = block.points[0].normal_impulse + block.points[1].normal_impulse;
    const Lanes old_impulse = block.rolling_impulse;
    const Lanes wanted = old_impulse - block.rolling_mass * roll;
    block.rolling_impulse = clamp_magnitude(wanted, block.rolling_resistance * normal_impulse);
    const Lanes change = block.rolling_impulse - old_impulse;
    apply_rolling(block, change, state);
}

// A point that bounces: where an impulse stopped an approach fast enough. 1 or 0.
TUMBLE_LANE_FUNCTION Lanes is_bouncing(const ContactBlock& block, int point, float threshold) {
    const Lanes zero = Lanes::Zero(), one = Lanes::Ones();
    const Lanes was_fast = select_less(block.approach_speed[point], Lanes::Constant(-threshold), one, zero);
    return select_less(zero, block.points[point].applied_normal, was_fast, zero);
}

// A bouncing point is to part with e times the speed of its impact where it met: at a separation s under the acceleration
// a with (v + a h / 2)^2 = (e v_impact)^2 + 2 a s, as in set_approaches(). Others keep their impulses.
TUMBLE_LANE_FUNCTION NormalRow make_bounce_row(const ContactBlock& block, int index, const Lanes& shift,
                                               const Lanes& bouncing, float h, const BlockState& state) {
    const ContactBlockPoint& point = block.points[index];
    const Lanes zero = Lanes::Zero();
    const Lanes back = block.restitution * block.approach_speed[index];
    const Lanes fallen = 2.0f * block.acceleration * current_separation(block, point, shift, state);
    const Lanes wanted = (back * back + fallen).max(zero).sqrt() - 0.5f * h * block.acceleration;
    const Lanes missing = select_less(zero, bouncing, normal_velocity(point, state) - wanted, zero);
    return {point.inverse_mass, missing - point.inverse_mass * point.normal_impulse};
}

// Both points at once: one after the other they would make a box that falls flat spin.
TUMBLE_LANE_FUNCTION void solve_restitution(ContactBlock& block, float threshold, float h, BlockState& state) {
    const Lanes shift = center_shift(block, state);
    const Lanes first_bounces = is_bouncing(block, 0, threshold), second_bounces = is_bouncing(block, 1, threshold);
    const NormalRow first = make_bounce_row(block, 0, shift, first_bounces, h, state);
    const NormalRow second = make_bounce_row(block, 1, shift, second_bounces, h, state);
    const Lanes coupling = block.coupling * first_bounces * second_bounces;
    solve_normals(block, coupling, first, second, state);
}

}  // namespace

void warm_start_contacts(std::span<const ContactBlock> blocks, std::span<SolverBody> bodies) {
    for (const ContactBlock& block : blocks) {
        BlockState state = load(block, bodies);
        for (const ContactBlockPoint& point : block.points) {
            apply_normal(block, point, point.normal_impulse, state);
            apply_tangent(block, point, point.tangent_impulse, state);
        }
        if (block.has_rolling_resistance) apply_rolling(block, block.rolling_impulse, state);
        finish(block, state, bodies);
    }
}

void solve_contacts(std::span<ContactBlock> blocks, std::span<SolverBody> bodies, float inv_h, float push_out_speed) {
    for (ContactBlock& block : blocks) {
        BlockState state = load(block, bodies);
        const Lanes shift = center_shift(block, state);
        const NormalRow first = make_soft_row(block, block.points[0], shift, inv_h, push_out_speed, state);
        const NormalRow second = make_soft_row(block, block.points[1], shift, inv_h, push_out_speed, state);
        solve_normals(block, block.coupling, first, second, state);
        finish(block, state, bodies);
    }
}

void relax_contacts(std::span<ContactBlock> blocks, std::span<SolverBody> bodies, float inv_h) {
    for (ContactBlock& block : blocks) {
        BlockState state = load(block, bodies);
        const Lanes shift = center_shift(block, state);
        for (ContactBlockPoint& point : block.points) solve_friction(block, point, state);
        if (block.has_rolling_resistance) solve_rolling(block, state);
        const NormalRow first = make_rigid_row(block, block.points[0], shift, inv_h, state);
        const NormalRow second = make_rigid_row(block, block.points[1], shift, inv_h, state);
        solve_normals(block, block.coupling, first, second, state);
        for (ContactBlockPoint& point : block.points) point.applied_normal += point.normal_impulse;
        finish(block, state, bodies);
    }
}

void apply_restitution(std::span<ContactBlock> blocks, std::span<SolverBody> bodies, float threshold, float h) {
    for (ContactBlock& block : blocks) {
        if (!block.has_restitution) continue;
        BlockState state = load(block, bodies);
        const Lanes before1 = block.points[0].normal_impulse, before2 = block.points[1].normal_impulse;
        solve_restitution(block, threshold, h, state);
        block.points[0].applied_normal += block.points[0].normal_impulse - before1;
        block.points[1].applied_normal += block.points[1].normal_impulse - before2;
        finish(block, state, bodies);
    }
}

}  // namespace tumble
