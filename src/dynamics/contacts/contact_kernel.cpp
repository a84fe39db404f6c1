// The contact kernels: projected Gauss-Seidel over blocks of eight contacts, soft in the pass with bias, otherwise
// rigid.
#include "debug/check.hpp"
#include "dynamics/contacts/contact_normals.hpp"

namespace tumble {

namespace {

// A gap is speculative: the row is rigid and lets the gap close within the sub-step. Overlap is removed by an implicit
// spring and damper, whose mass scale divides the diagonal, at most at the push-out speed.
TUMBLE_LANE_FUNCTION NormalRow make_soft_row(const ContactBlock& block, const ContactBlockPoint& point,
                                             const Lanes& shift, float inv_h, float push_out_speed,
                                             const BlockState& state) {
    const Lanes zero = Lanes::Zero();
    const Lanes separation = current_separation(block, point, shift, state);
    const Lanes gap = larger(separation, zero), overlap = smaller(separation, zero);
    TUMBLE_CHECK(block.softness.mass_scale > 0.0f);
    const float max_push = push_out_speed / block.softness.mass_scale;  // before the mass scale
    const Lanes bias = gap * inv_h + larger(overlap * block.softness.bias_rate, Lanes::Constant(-max_push));
    const Lanes soft = point.inverse_mass * (1.0f / block.softness.mass_scale);
    const Lanes diagonal = select_less(zero, separation, point.inverse_mass, soft);
    const Lanes softened = (1.0f - block.softness.impulse_scale) * point.normal_impulse;
    const Lanes kept = select_less(zero, separation, point.normal_impulse, softened);
    return {diagonal, normal_velocity(point, state) + bias - diagonal * kept};
}

struct Lanes2 {
    Lanes first, second;
};

// The normal velocities at which the gaps of both points close within a sub-step; 0 without a gap.
TUMBLE_LANE_FUNCTION Lanes2 closing_speeds(const ContactBlock& block, float inv_h, const BlockState& state) {
    const Lanes shift = center_shift(block, state), zero = Lanes::Zero();
    return {larger(current_separation(block, block.points[0], shift, state), zero) * inv_h,
            larger(current_separation(block, block.points[1], shift, state), zero) * inv_h};
}

TUMBLE_LANE_FUNCTION NormalRow make_rigid_row(const ContactBlockPoint& point, const Lanes& closing_speed,
                                              const BlockState& state) {
    return {point.inverse_mass,
            normal_velocity(point, state) + closing_speed - point.inverse_mass * point.normal_impulse};
}

// The tangential velocity of B's surface relative to A's, with that of conveyor belts.
TUMBLE_LANE_FUNCTION Lanes slip_speed(const ContactBlock& block, const ContactBlockPoint& point,
                                      const BlockState& state) {
    const Lanes velocity = tangent_velocity(point, state);
    return block.has_tangent_speed ? velocity + block.extras->tangent_speed : velocity;
}

// Applies a tangent impulse. With restitution it also adds up the work, as push_normals() does.
TUMBLE_LANE_FUNCTION void push_tangent(ContactBlock& block, const ContactBlockPoint& point, const Lanes& impulse,
                                       BlockState& state) {
    if (block.has_restitution) block.extras->friction_work += 0.5f * impulse * slip_speed(block, point, state);
    apply_tangent(block, point, impulse, state);
    if (block.has_restitution) block.extras->friction_work += 0.5f * impulse * slip_speed(block, point, state);
}

// Coulomb friction against the load: the normal impulse of the point.
TUMBLE_LANE_FUNCTION void solve_friction(ContactBlock& block, ContactBlockPoint& point, const Lanes& load,
                                         BlockState& state) {
    TUMBLE_CHECK((block.friction >= 0.0f).all());
    const Lanes old_impulse = point.tangent_impulse;
    const Lanes wanted = old_impulse - point.tangent_mass * slip_speed(block, point, state);
    point.tangent_impulse = clamp_magnitude(wanted, block.friction * load);
    point.applied_tangent += point.tangent_impulse;
    push_tangent(block, point, point.tangent_impulse - old_impulse, state);
}

// An angular impulse against rolling, at most the resistance times the load.
TUMBLE_LANE_FUNCTION void solve_rolling(ContactBlock& block, const Lanes& load, BlockState& state) {
    const Lanes roll = state.b.angular_velocity - state.a.angular_velocity;
    TUMBLE_CHECK((block.extras->rolling_resistance >= 0.0f).all());
    const Lanes old_impulse = block.extras->rolling_impulse;
    const Lanes wanted = old_impulse - block.extras->rolling_mass * roll;
    block.extras->rolling_impulse = clamp_magnitude(wanted, block.extras->rolling_resistance * load);
    const Lanes change = block.extras->rolling_impulse - old_impulse;
    apply_rolling(block, change, state);
}

// The normal impulses that the rigid rows ask for now. The impulses of the pass with bias also push overlap out, and
// friction against those would be up to 3.6 times too strong.
TUMBLE_LANE_FUNCTION Lanes2 find_loads(const ContactBlock& block, const Lanes2& closing, const BlockState& state) {
    const NormalRow first = make_rigid_row(block.points[0], closing.first, state);
    const NormalRow second = make_rigid_row(block.points[1], closing.second, state);
    Lanes change1, change2;
    find_changes(block, block.coupling, first, second, change1, change2);
    return {block.points[0].normal_impulse + change1, block.points[1].normal_impulse + change2};
}

}  // namespace

TUMBLE_LANE_KERNEL void warm_start_contacts(std::span<ContactBlock> blocks, std::span<SolverBody> bodies) {
    for (ContactBlock& block : blocks) {
        BlockState state = load(block, bodies);
        push_normals(block, block.points[0].normal_impulse, block.points[1].normal_impulse, state);
        for (const ContactBlockPoint& point : block.points) push_tangent(block, point, point.tangent_impulse, state);
        if (block.has_rolling_resistance) apply_rolling(block, block.extras->rolling_impulse, state);
        finish(block, state, bodies);
    }
}

TUMBLE_LANE_KERNEL void solve_contacts(std::span<ContactBlock> blocks, std::span<SolverBody> bodies, float inv_h,
                                       float push_out_speed) {
    TUMBLE_CHECK(inv_h > 0.0f);
    TUMBLE_CHECK(push_out_speed >= 0.0f);
    for (ContactBlock& block : blocks) {
        BlockState state = load(block, bodies);
        const Lanes shift = center_shift(block, state);
        const NormalRow first = make_soft_row(block, block.points[0], shift, inv_h, push_out_speed, state);
        const NormalRow second = make_soft_row(block, block.points[1], shift, inv_h, push_out_speed, state);
        solve_normals(block, first, second, state);
        finish(block, state, bodies);
    }
}

TUMBLE_LANE_KERNEL void relax_contacts(std::span<ContactBlock> blocks, std::span<SolverBody> bodies, float inv_h,
                                       FrictionBound bound) {
    TUMBLE_CHECK(inv_h > 0.0f);
    for (ContactBlock& block : blocks) {
        BlockState state = load(block, bodies);
        const Lanes2 closing = closing_speeds(block, inv_h, state);
        const Lanes2 loads = bound == FrictionBound::rigid
                                 ? find_loads(block, closing, state)
                                 : Lanes2{block.points[0].normal_impulse, block.points[1].normal_impulse};
        solve_friction(block, block.points[0], loads.first, state);
        solve_friction(block, block.points[1], loads.second, state);
        if (block.has_rolling_resistance) solve_rolling(block, loads.first + loads.second, state);
        const NormalRow first = make_rigid_row(block.points[0], closing.first, state);
        const NormalRow second = make_rigid_row(block.points[1], closing.second, state);
        solve_normals(block, first, second, state);
        for (ContactBlockPoint& point : block.points) point.applied_normal += point.normal_impulse;
        finish(block, state, bodies);
    }
}

}  // namespace tumble
