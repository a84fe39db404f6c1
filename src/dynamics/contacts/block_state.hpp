// The bodies of a contact block while it is solved.
//
// Velocities are relative and in the contact's frame: each impulse updates the normal and tangent velocity of the
// centres of mass and the two angular velocities; the linear velocities of the bodies are updated once, at the end of a
// block. If a body is locked along one axis, a normal impulse changes the tangent velocity too. That change is
// neglected until the block is loaded again.
#pragma once

#include "debug/check.hpp"
#include "dynamics/bodies/body_lanes.hpp"
#include "dynamics/contacts/contact_block.hpp"

namespace tumble {

// The two bodies of each lane while their block is solved.
struct BlockState {
    BodyLanes a, b;
    Lanes normal_velocity;  // of B's centre relative to A's, m/s
    Lanes tangent_velocity;
    Lanes normal_impulse;  // applied since load() and not yet in the bodies' linear velocities, N s
    Lanes tangent_impulse;
    Lanes linear_normal;  // inverse mass of both bodies along the normal, 1/kg
    Lanes linear_tangent;
};

TUMBLE_LANE_FUNCTION BlockState load(const ContactBlock& block, std::span<const SolverBody> bodies) {
    BlockState state;
    state.a = gather(bodies, block.body_a);
    state.b = gather(bodies, block.body_b);
    const Lanes x = state.b.velocity_x - state.a.velocity_x;
    const Lanes y = state.b.velocity_y - state.a.velocity_y;
    state.normal_velocity = x * block.normal_x + y * block.normal_y;
    state.tangent_velocity = x * block.normal_y - y * block.normal_x;
    state.normal_impulse = Lanes::Zero();
    state.tangent_impulse = Lanes::Zero();
    state.linear_normal = state.linear_tangent = block.inv_mass_a + block.inv_mass_b;
    if (block.has_locks) {
        state.linear_normal = block.extras->locked.normal;
        state.linear_tangent = block.extras->locked.tangent;
    }
    return state;
}

TUMBLE_LANE_FUNCTION void finish(const ContactBlock& block, BlockState& state, std::span<SolverBody> bodies) {
    const Lanes x = state.normal_impulse * block.normal_x + state.tangent_impulse * block.normal_y;
    const Lanes y = state.normal_impulse * block.normal_y - state.tangent_impulse * block.normal_x;
    if (block.has_locks) {
        state.a.velocity_x -= block.extras->locked.ax * x;
        state.a.velocity_y -= block.extras->locked.ay * y;
        state.b.velocity_x += block.extras->locked.bx * x;
        state.b.velocity_y += block.extras->locked.by * y;
    } else {
        state.a.velocity_x -= block.inv_mass_a * x;
        state.a.velocity_y -= block.inv_mass_a * y;
        state.b.velocity_x += block.inv_mass_b * x;
        state.b.velocity_y += block.inv_mass_b * y;
    }
    scatter_velocities(state.a, bodies, block.body_a, block.moved_a);
    scatter_velocities(state.b, bodies, block.body_b, block.moved_b);
}

TUMBLE_LANE_FUNCTION Lanes normal_velocity(const ContactBlockPoint& point, const BlockState& state) {
    return state.normal_velocity + state.b.angular_velocity * point.across_b -
           state.a.angular_velocity * point.across_a;
}

TUMBLE_LANE_FUNCTION Lanes tangent_velocity(const ContactBlockPoint& point, const BlockState& state) {
    return state.tangent_velocity - state.b.angular_velocity * point.along_b + state.a.angular_velocity * point.along_a;
}

TUMBLE_LANE_FUNCTION void apply_normal(const ContactBlock& block, const ContactBlockPoint& point, const Lanes& impulse,
                                       BlockState& state) {
    state.normal_impulse += impulse;
    state.normal_velocity += state.linear_normal * impulse;
    state.a.angular_velocity -= block.inv_inertia_a * point.across_a * impulse;
    state.b.angular_velocity += block.inv_inertia_b * point.across_b * impulse;
}

TUMBLE_LANE_FUNCTION void apply_tangent(const ContactBlock& block, const ContactBlockPoint& point, const Lanes& impulse,
                                        BlockState& state) {
    state.tangent_impulse += impulse;
    state.tangent_velocity += state.linear_tangent * impulse;
    state.a.angular_velocity += block.inv_inertia_a * point.along_a * impulse;
    state.b.angular_velocity -= block.inv_inertia_b * point.along_b * impulse;
}

TUMBLE_LANE_FUNCTION void apply_rolling(const ContactBlock& block, const Lanes& impulse, BlockState& state) {
    state.a.angular_velocity -= block.inv_inertia_a * impulse;
    state.b.angular_velocity += block.inv_inertia_b * impulse;
}

// The change of the distance of the centres along the normal since the start of the step, m; negative if they approach.
TUMBLE_LANE_FUNCTION Lanes center_shift(const ContactBlock& block, const BlockState& state) {
    const Lanes x = state.b.delta_x - state.a.delta_x;
    const Lanes y = state.b.delta_y - state.a.delta_y;
    return x * block.normal_x + y * block.normal_y;
}

// The present separation of a point, from anchors fixed on the bodies at the start of the step:
//   s0 + (dp_B - dp_A + (R(dq_B) - 1) r_B - (R(dq_A) - 1) r_A) . n
//
// The anchors are on the cores, and the rounding stays along the normal while the bodies turn. Anchors on the surface
// would lift a rolling ball by r (1 - cos) in every step, and it would lose its grip.
TUMBLE_LANE_FUNCTION Lanes current_separation(const ContactBlock& block, const ContactBlockPoint& point,
                                              const Lanes& shift, const BlockState& state) {
    const Lanes one = Lanes::Ones();
    Lanes along_a = point.along_a, along_b = point.along_b;
    if (block.has_radius) {
        along_a -= block.extras->radius_a;
        along_b += block.extras->radius_b;
    }
    const Lanes turn_a = (state.a.delta_c - one) * along_a + state.a.delta_s * point.across_a;
    const Lanes turn_b = (state.b.delta_c - one) * along_b + state.b.delta_s * point.across_b;
    return point.separation + shift + (turn_b - turn_a);
}

}  // namespace tumble
