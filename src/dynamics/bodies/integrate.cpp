#include "dynamics/bodies/integrate.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "debug/check.hpp"
#include "dynamics/bodies/body_lanes.hpp"

namespace tumble {

namespace {

constexpr std::size_t kLeastIntegrated = 512;  // in a chunk: about 3 us of work

// Within a step a body may be given more spin than it may have at the end, and only turns less: friction that gives a
// spin in one sub-step and takes it back in the next would otherwise leave the opposite one. Joints that contradict
// each other would drive a body ever faster.
float spin_limit_within_step(const SolverBody& body, const BodyStore& bodies, std::size_t i,
                             const SpeedLimits& limits) {
    const bool exceeds = std::abs(body.angular_velocity) > limits.spin;
    const bool is_joined = exceeds && !bodies.records[bodies.moving[i].body].joints.empty();
    return is_joined ? spin_limit(body, limits) : limits.fast_spin;
}

// Few bodies are that fast, and all are asked twice in a sub-step. NaN exceeds nothing: clamp_speed() does not
// change it.
bool exceeds_limits(const SolverBody& body, const SpeedLimits& limits) {
    return length_sq(body.velocity) > limits.speed * limits.speed || std::abs(body.angular_velocity) > limits.spin;
}

void clamp_within_step(BodyStore& bodies, std::size_t i, const SpeedLimits& limits) {
    SolverBody& body = bodies.solver_bodies[i];
    if (!exceeds_limits(body, limits)) return;
    clamp_speed(body, limits, spin_limit_within_step(body, bodies, i, limits));
}

// The formulas for one body, and for lanes of bodies, which take 10 % less of the time to solve a pile.
template <class T>
void accelerate(T& velocity, const T& acceleration, const T& damping, float h) {
    const T decay = 1.0f / (1.0f + h * damping);
    velocity = decay * (velocity + h * acceleration);
}

template <class T, class Turn>
void advance(T& x, T& y, Turn& turn, const T& velocity_x, const T& velocity_y, const T& spin, float h) {
    x += h * velocity_x;
    y += h * velocity_y;
    const T angle = h * spin;
    turn = compose(small_rotation<Turn>(angle), turn);
}

void integrate_velocity(SolverBody& body, const MovingBody& moving, Vec2 gravity, float h) {
    const Vec2 acceleration = moving.free_acceleration(gravity);
    Vec2 velocity = body.velocity;
    float spin = body.angular_velocity;
    accelerate(velocity.x, acceleration.x, moving.motion.linear_damping, h);
    accelerate(velocity.y, acceleration.y, moving.motion.linear_damping, h);
    accelerate(spin, moving.angular_acceleration, moving.motion.angular_damping, h);
    body.velocity = allowed(body.flags, velocity);
    body.angular_velocity = allowed(body.flags, spin);
}

void integrate_position(SolverBody& body, float h, const SpeedLimits& limits) {
    float spin = body.angular_velocity;
    if (body.flags & kDynamicBody) spin = std::clamp(spin, -spin_limit(body, limits), spin_limit(body, limits));
    advance(body.delta_position.x, body.delta_position.y, body.delta_rotation, body.velocity.x, body.velocity.y, spin,
            h);
}

// Eight floats of each of eight records that follow one another.
template <class Record>
TUMBLE_LANE_FUNCTION void gather_from(const Record* first, std::size_t offset, Lanes fields[8]) {
    const Record* records[kLaneCount];
    for (int lane = 0; lane < kLaneCount; ++lane) records[lane] = first + lane;
    gather_members(records, offset, fields);
}

TUMBLE_LANE_FUNCTION BodyLanes load(const SolverBody* first) {
    const float* rows[kLaneCount];
    for (int lane = 0; lane < kLaneCount; ++lane) rows[lane] = &first[lane].velocity.x;
    return gather_bodies(rows);
}

TUMBLE_LANE_FUNCTION bool any_exceeds_limits(const BodyLanes& bodies, const SpeedLimits& limits) {
    const Lanes speed_sq = bodies.velocity_x * bodies.velocity_x + bodies.velocity_y * bodies.velocity_y;
    return any_less(Lanes::Constant(limits.speed * limits.speed), speed_sq) ||
           any_less(Lanes::Constant(limits.spin), bodies.angular_velocity.abs());
}

bool are_free(const SolverBody* bodies) {
    constexpr std::uint32_t kConditions = kDynamicBody | kLockX | kLockY | kLockRotation;
    for (int lane = 0; lane < kLaneCount; ++lane)
        if ((bodies[lane].flags & kConditions) != kDynamicBody) return false;
    return true;
}

// The velocities of eight free bodies. Returns true if one exceeds the limits.
[[gnu::noinline]] TUMBLE_LANE_KERNEL bool integrate_eight_velocities(SolverBody* bodies, const MovingBody* moving,
                                                                     Vec2 gravity, float h, const SpeedLimits& limits) {
    // The last eight floats contain the forces: eight from the first force on would end beyond the record.
    constexpr std::size_t kMotion = offsetof(MovingBody, motion), kForces = sizeof(MovingBody) - 8 * sizeof(float);
    static_assert(offsetof(BodyMotion, gravity_scale) == 0 && offsetof(BodyMotion, angular_damping) == 8);
    static_assert(offsetof(MovingBody, acceleration) == kForces + 20);
    static_assert(offsetof(MovingBody, angular_acceleration) == kForces + 28);
    Lanes motion[8], forces[8];
    gather_from(moving, kMotion, motion);
    gather_from(moving, kForces, forces);
    BodyLanes eight = load(bodies);
    const Lanes acceleration_x = motion[0] * gravity.x + forces[5], acceleration_y = motion[0] * gravity.y + forces[6];
    accelerate(eight.velocity_x, acceleration_x, motion[1], h);
    accelerate(eight.velocity_y, acceleration_y, motion[1], h);
    accelerate(eight.angular_velocity, forces[7], motion[2], h);
    float* rows[kLaneCount];
    for (int lane = 0; lane < kLaneCount; ++lane) rows[lane] = &bodies[lane].velocity.x;
    scatter_rows(eight.velocity_x, eight.velocity_y, eight.angular_velocity, eight.flags, rows);
    return any_exceeds_limits(eight, limits);
}

// The positions of eight bodies. Returns false, and does nothing, if one exceeds the limits.
[[gnu::noinline]] TUMBLE_LANE_KERNEL bool integrate_eight_positions(SolverBody* bodies, float h,
                                                                    const SpeedLimits& limits) {
    BodyLanes eight = load(bodies);
    if (any_exceeds_limits(eight, limits)) return false;
    LaneTurn turn{eight.delta_c, eight.delta_s};
    advance(eight.delta_x, eight.delta_y, turn, eight.velocity_x, eight.velocity_y, eight.angular_velocity, h);
    float* rows[kLaneCount];
    for (int lane = 0; lane < kLaneCount; ++lane) rows[lane] = &bodies[lane].delta_position.x;
    scatter_rows(eight.delta_x, eight.delta_y, turn.c, turn.s, rows);
    return true;
}

}  // namespace

void integrate_velocities(BodyStore& bodies, const BodyRange& range, Vec2 gravity, float h, const SpeedLimits& limits,
                          Crew& crew) {
    TUMBLE_CHECK(bodies.moving.size() == bodies.solver_bodies.size());
    TUMBLE_CHECK(range.begin > kStaticSolverBody);
    TUMBLE_CHECK(range.end <= bodies.moving.size());
    TUMBLE_CHECK(h > 0.0f);
    const auto integrate_one = [&](std::size_t i) {
        SolverBody& body = bodies.solver_bodies[i];
        if (!(body.flags & kDynamicBody)) return;
        integrate_velocity(body, bodies.moving[i], gravity, h);
        clamp_within_step(bodies, i, limits);
    };
    crew.for_each_chunk(range.end - range.begin, kLeastIntegrated, [&](const Chunk& chunk) {
        std::size_t i = range.begin + chunk.begin;
        const std::size_t end = range.begin + chunk.end;
        for (; i + kLaneCount <= end; i += kLaneCount) {
            SolverBody* const eight = &bodies.solver_bodies[i];
            if (!are_free(eight))
                for (std::size_t k = i; k < i + kLaneCount; ++k) integrate_one(k);
            else if (integrate_eight_velocities(eight, &bodies.moving[i], gravity, h, limits))
                for (std::size_t k = i; k < i + kLaneCount; ++k) clamp_within_step(bodies, k, limits);
        }
        for (; i < end; ++i) integrate_one(i);
    });
}

void integrate_positions(BodyStore& bodies, const BodyRange& range, float h, const SpeedLimits& limits, Crew& crew) {
    const auto integrate_one = [&](std::size_t i) {
        if (bodies.solver_bodies[i].flags & kDynamicBody) clamp_within_step(bodies, i, limits);
        integrate_position(bodies.solver_bodies[i], h, limits);
    };
    crew.for_each_chunk(range.end - range.begin, kLeastIntegrated, [&](const Chunk& chunk) {
        std::size_t i = range.begin + chunk.begin;
        const std::size_t end = range.begin + chunk.end;
        for (; i + kLaneCount <= end; i += kLaneCount)
            if (!integrate_eight_positions(&bodies.solver_bodies[i], h, limits))
                for (std::size_t k = i; k < i + kLaneCount; ++k) integrate_one(k);
        for (; i < end; ++i) integrate_one(i);
    });
}

}  // namespace tumble
