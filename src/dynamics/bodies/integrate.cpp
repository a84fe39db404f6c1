#include "dynamics/bodies/integrate.hpp"

#include <algorithm>
#include <cmath>

#include "debug/check.hpp"

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

// Few bodies are that fast, and all are asked twice in a sub-step. True for a velocity that is not a number.
bool exceeds_limits(const SolverBody& body, const SpeedLimits& limits) {
    return !(length_sq(body.velocity) <= limits.speed * limits.speed) ||
           !(std::abs(body.angular_velocity) <= limits.spin);
}

void clamp_within_step(BodyStore& bodies, std::size_t i, const SpeedLimits& limits) {
    SolverBody& body = bodies.solver_bodies[i];
    if (!exceeds_limits(body, limits)) return;
    clamp_speed(body, limits, spin_limit_within_step(body, bodies, i, limits));
}

void integrate_velocity(SolverBody& body, const MovingBody& moving, Vec2 gravity, float h) {
    const BodyMotion& motion = moving.motion;
    const float linear_decay = 1.0f / (1.0f + h * motion.linear_damping);
    const float angular_decay = 1.0f / (1.0f + h * motion.angular_damping);
    const Vec2 velocity = linear_decay * (body.velocity + h * moving.free_acceleration(gravity));
    const float spin = angular_decay * (body.angular_velocity + h * moving.angular_acceleration);
    body.velocity = allowed(body.flags, velocity);
    body.angular_velocity = allowed(body.flags, spin);
}

void integrate_position(SolverBody& body, float h, const SpeedLimits& limits) {
    float spin = body.angular_velocity;
    if (body.flags & kDynamicBody) spin = std::clamp(spin, -spin_limit(body, limits), spin_limit(body, limits));
    body.delta_position += h * body.velocity;
    body.delta_rotation = compose(small_rotation(h * spin), body.delta_rotation);
}

}  // namespace

void integrate_velocities(BodyStore& bodies, Vec2 gravity, float h, const SpeedLimits& limits, Crew& crew) {
    TUMBLE_CHECK(bodies.moving.size() == bodies.solver_bodies.size());
    TUMBLE_CHECK(h > 0.0f);
    crew.for_each(bodies.solver_bodies.size(), kLeastIntegrated, [&](std::size_t i) {
        SolverBody& body = bodies.solver_bodies[i];
        if (!(body.flags & kDynamicBody)) return;
        integrate_velocity(body, bodies.moving[i], gravity, h);
        clamp_within_step(bodies, i, limits);
    });
}

void integrate_positions(BodyStore& bodies, float h, const SpeedLimits& limits, Crew& crew) {
    crew.for_each(bodies.solver_bodies.size(), kLeastIntegrated, [&](std::size_t i) {
        if (i == kStaticSolverBody) return;
        if (bodies.solver_bodies[i].flags & kDynamicBody) clamp_within_step(bodies, i, limits);
        integrate_position(bodies.solver_bodies[i], h, limits);
    });
}

}  // namespace tumble
