// The kernels of blocks of eight revolute joints.
#include "debug/check.hpp"
#include "dynamics/joint_store/revolute_block.hpp"
#include "dynamics/rows/joint_angle.hpp"
#include "dynamics/rows/joint_block.hpp"
#include "simd/double_lanes.hpp"

namespace tumble {

namespace {

struct Lanes2 {
    Lanes x, y;
};

// The bodies of the joints, and the arms of the anchors, which turn with them.
struct JointState {
    BodyLanes a, b;
    Lanes2 arm_a, arm_b;
};

TUMBLE_LANE_FUNCTION Lanes2 turned(const BodyLanes& body, const Lanes& x, const Lanes& y) {
    return {body.delta_c * x - body.delta_s * y, body.delta_s * x + body.delta_c * y};
}

TUMBLE_LANE_FUNCTION JointState load(const RevoluteBlock& block, std::span<const SolverBody> bodies) {
    JointState state;
    state.a = gather(bodies, block.body_a);
    state.b = gather(bodies, block.body_b);
    state.arm_a = turned(state.a, block.arm_ax, block.arm_ay);
    state.arm_b = turned(state.b, block.arm_bx, block.arm_by);
    return state;
}

TUMBLE_LANE_FUNCTION void finish(const RevoluteBlock& block, const JointState& state, std::span<SolverBody> bodies) {
    scatter_velocities(state.a, bodies, block.body_a, block.moved_a);
    scatter_velocities(state.b, bodies, block.body_b, block.moved_b);
}

TUMBLE_LANE_FUNCTION void turn(const RevoluteBlock& block, const Lanes& impulse, JointState& state) {
    state.a.angular_velocity -= block.inv_inertia_a * impulse;
    state.b.angular_velocity += block.inv_inertia_b * impulse;
}

TUMBLE_LANE_FUNCTION void push(const RevoluteBlock& block, const Lanes2& impulse, JointState& state) {
    state.a.velocity_x -= block.inv_mass_a * impulse.x;
    state.a.velocity_y -= block.inv_mass_a * impulse.y;
    state.a.angular_velocity -= block.inv_inertia_a * (state.arm_a.x * impulse.y - state.arm_a.y * impulse.x);
    state.b.velocity_x += block.inv_mass_b * impulse.x;
    state.b.velocity_y += block.inv_mass_b * impulse.y;
    state.b.angular_velocity += block.inv_inertia_b * (state.arm_b.x * impulse.y - state.arm_b.y * impulse.x);
}

// relative_turn() of each lane.
TUMBLE_LANE_FUNCTION Lanes relative_turns(const BodyLanes& a, const BodyLanes& b) {
    using Doubles = DoubleLanes<kLaneCount>;
    const Doubles ac = load_widened<kLaneCount>(a.delta_c.data()), as = load_widened<kLaneCount>(a.delta_s.data());
    const Doubles bc = load_widened<kLaneCount>(b.delta_c.data()), bs = load_widened<kLaneCount>(b.delta_s.data());
    const Doubles sine = ac * bs - as * bc, cosine = ac * bc + as * bs;
    const auto is_small = larger(sine, -sine) < 0.125 * cosine;
    Lanes turns;
    store_narrowed(small_arc_tangent(sine / cosine), turns.data());
    const unsigned small = bits_of(is_small);
    if (small != kAllLanes) [[unlikely]]
        for (int lane = 0; lane < kLaneCount; ++lane)
            if (!(small >> lane & 1u)) turns[lane] = static_cast<float>(arc_tangent(sine[lane], cosine[lane]));
    return turns;
}

TUMBLE_LANE_FUNCTION Lanes spin(const JointState& state) { return state.b.angular_velocity - state.a.angular_velocity; }

TUMBLE_LANE_FUNCTION void solve_spring(RevoluteBlock& block, const Lanes& angle, const Lanes& mass, JointState& state) {
    const Lanes speed = spin(state) + block.spring_bias_rate * angle;
    const Lanes change = -block.spring_mass_scale * mass * speed - block.spring_impulse_scale * block.spring_impulse;
    block.spring_impulse += change;
    turn(block, change, state);
}

// The motor does not drive the joint beyond its limits within the sub-step.
TUMBLE_LANE_FUNCTION void solve_motor(RevoluteBlock& block, const Lanes& angle, const Lanes& mass, float inv_h,
                                      JointState& state) {
    Lanes wanted_speed = block.motor_speed;
    if (block.has_limits) {
        const Lanes zero = Lanes::Zero();
        const Lanes slowest = smaller((block.lower - angle) * inv_h, zero);
        const Lanes fastest = larger((block.upper - angle) * inv_h, zero);
        wanted_speed = smaller(larger(wanted_speed, slowest), fastest);
    }
    const Lanes wanted = block.motor_impulse - mass * (spin(state) - wanted_speed);
    const Lanes total = clamp_magnitude(wanted, block.motor_most);
    turn(block, total - block.motor_impulse, state);
    block.motor_impulse = total;
}

// solve_limit(): `side` is +1 for the lower limit and -1 for the upper one.
TUMBLE_LANE_FUNCTION void solve_limit(const RevoluteBlock& block, float side, const Lanes& gap, const Lanes& mass,
                                      const Softness& softness, float inv_h, Lanes& impulse, JointState& state) {
    const Lanes zero = Lanes::Zero();
    const Lanes free_bias = gap * inv_h, soft_bias = softness.bias_rate * gap;
    const Lanes speed = side * spin(state) + select_less(zero, gap, free_bias, soft_bias);
    const Lanes free_change = -mass * speed;
    const Lanes soft_change = -softness.mass_scale * mass * speed - softness.impulse_scale * impulse;
    const Lanes total = larger(impulse + select_less(zero, gap, free_change, soft_change), zero);
    turn(block, side * (total - impulse), state);
    impulse = total;
}

TUMBLE_LANE_FUNCTION void solve_drive(RevoluteBlock& block, const JointContext& context, bool use_bias,
                                      JointState& state) {
    const Lanes inertia = block.inv_inertia_a + block.inv_inertia_b;
    const Lanes mass = Lanes::Ones() / inertia;
    const bool solves_spring = block.has_spring && use_bias;
    Lanes angle = block.angle;
    if (solves_spring || block.has_limits) angle += relative_turns(state.a, state.b);
    if (solves_spring) solve_spring(block, angle, mass, state);
    if (block.has_motor) solve_motor(block, angle, mass, context.inv_h, state);
    if (!block.has_limits) return;
    const Softness softness = use_bias ? context.softness : Softness{};
    solve_limit(block, 1.0f, angle - block.lower, mass, softness, context.inv_h, block.lower_impulse, state);
    solve_limit(block, -1.0f, block.upper - angle, mass, softness, context.inv_h, block.upper_impulse, state);
}

// From A's anchors to B's.
TUMBLE_LANE_FUNCTION Lanes2 separations(const RevoluteBlock& block, const JointState& state) {
    return {block.center_x + (state.b.delta_x - state.a.delta_x) + (state.arm_b.x - state.arm_a.x),
            block.center_y + (state.b.delta_y - state.a.delta_y) + (state.arm_b.y - state.arm_a.y)};
}

// The velocities of B's anchors relative to A's.
TUMBLE_LANE_FUNCTION Lanes2 anchor_velocities(const JointState& state) {
    return {(state.b.velocity_x - state.b.angular_velocity * state.arm_b.y) -
                (state.a.velocity_x - state.a.angular_velocity * state.arm_a.y),
            (state.b.velocity_y + state.b.angular_velocity * state.arm_b.x) -
                (state.a.velocity_y + state.a.angular_velocity * state.arm_a.x)};
}

// BlockMatrix of each lane.
struct MatrixLanes {
    Lanes k11, k12, k22;
};

TUMBLE_LANE_FUNCTION MatrixLanes point_matrices(const RevoluteBlock& block, const JointState& state) {
    const Lanes linear = block.inv_mass_a + block.inv_mass_b;
    const Lanes &ia = block.inv_inertia_a, &ib = block.inv_inertia_b;
    const Lanes2 &arm_a = state.arm_a, &arm_b = state.arm_b;
    return {linear + ia * arm_a.y * arm_a.y + ib * arm_b.y * arm_b.y, -ia * arm_a.x * arm_a.y - ib * arm_b.x * arm_b.y,
            linear + ia * arm_a.x * arm_a.x + ib * arm_b.x * arm_b.x};
}

// One row of a point in the lanes where `is_regular` is 0, as solve_equality(). The velocities are those of the bodies
// along its axis.
TUMBLE_LANE_FUNCTION void solve_row(const RevoluteBlock& block, const Softness& softness, const Lanes& is_regular,
                                    const Lanes& k, const Lanes& angular_a, const Lanes& angular_b, const Lanes& error,
                                    Lanes& velocity_a, Lanes& velocity_b, Lanes& impulse, JointState& state) {
    const Lanes zero = Lanes::Zero();
    const Lanes speed = (velocity_b - velocity_a) + angular_b * state.b.angular_velocity -
                        angular_a * state.a.angular_velocity + softness.bias_rate * error;
    const Lanes wanted = -softness.mass_scale * (1.0f / k) * speed - softness.impulse_scale * impulse;
    const Lanes change = select_less(zero, is_regular, zero, wanted);
    impulse += change;
    velocity_a -= change * block.inv_mass_a;
    velocity_b += change * block.inv_mass_b;
    state.a.angular_velocity -= block.inv_inertia_a * change * angular_a;
    state.b.angular_velocity += block.inv_inertia_b * change * angular_b;
}

TUMBLE_LANE_FUNCTION void solve_point(RevoluteBlock& block, const Softness& softness, bool use_bias,
                                      JointState& state) {
    const MatrixLanes k = point_matrices(block, state);
    const Lanes zero = Lanes::Zero(), determinant = k.k11 * k.k22 - k.k12 * k.k12;
    Lanes2 speed = anchor_velocities(state), error{zero, zero};
    if (use_bias) {
        error = separations(block, state);
        speed.x += softness.bias_rate * error.x;
        speed.y += softness.bias_rate * error.y;
    }
    const Lanes scale = softness.mass_scale / determinant;
    Lanes2 change{-(scale * (k.k22 * speed.x - k.k12 * speed.y)) - softness.impulse_scale * block.impulse_x,
                  -(scale * (k.k11 * speed.y - k.k12 * speed.x)) - softness.impulse_scale * block.impulse_y};
    const Lanes is_regular = select_less(kSingular * k.k11 * k.k22, determinant, Lanes::Ones(), zero);
    const bool has_singular = any_less(is_regular, Lanes::Constant(0.5f));
    if (has_singular) [[unlikely]]
        change = {select_less(zero, is_regular, change.x, zero), select_less(zero, is_regular, change.y, zero)};
    block.impulse_x += change.x;
    block.impulse_y += change.y;
    push(block, change, state);
    if (!has_singular) [[likely]]
        return;
    solve_row(block, softness, is_regular, k.k11, -state.arm_a.y, -state.arm_b.y, error.x, state.a.velocity_x,
              state.b.velocity_x, block.impulse_x, state);
    solve_row(block, softness, is_regular, k.k22, state.arm_a.x, state.arm_b.x, error.y, state.a.velocity_y,
              state.b.velocity_y, block.impulse_y, state);
}

}  // namespace

TUMBLE_LANE_KERNEL void warm_start_joints(const RevoluteBlock& block, std::span<SolverBody> bodies) {
    JointState state = load(block, bodies);
    if (block.has_drive())
        turn(block, block.spring_impulse + block.motor_impulse + block.lower_impulse - block.upper_impulse, state);
    push(block, {block.impulse_x, block.impulse_y}, state);
    finish(block, state, bodies);
}

TUMBLE_LANE_KERNEL void solve_joints(RevoluteBlock& block, const JointContext& context, bool use_bias,
                                     std::span<SolverBody> bodies) {
    TUMBLE_CHECK(context.iterates_equalities);
    JointState state = load(block, bodies);
    if (block.has_drive()) solve_drive(block, context, use_bias, state);
    solve_point(block, context.equality_softness(use_bias), use_bias, state);
    finish(block, state, bodies);
}

}  // namespace tumble
