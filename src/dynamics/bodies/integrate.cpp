#include "dynamics/bodies/integrate.hpp"

#include "debug/check.hpp"

namespace tumble {

namespace {

constexpr std::size_t kLeastIntegrated = 512;  // in a chunk: about 3 us of work

void integrate_velocity(SolverBody& body, const MovingBody& moving, Vec2 gravity, float h, const SpeedLimits& limits) {
    const BodyMotion& motion = moving.motion;
    const float linear_decay = 1.0f / (1.0f + h * motion.linear_damping);
    const float angular_decay = 1.0f / (1.0f + h * motion.angular_damping);
    const Vec2 velocity = linear_decay * (body.velocity + h * moving.free_acceleration(gravity));
    const float spin = angular_decay * (body.angular_velocity + h * moving.angular_acceleration);
    body.velocity = allowed(body.flags, velocity);
    body.angular_velocity = allowed(body.flags, spin);
    clamp_speed(body, limits);
}

void integrate_position(SolverBody& body, float h, const SpeedLimits& limits) {
    if (body.flags & kDynamicBody) clamp_speed(body, limits);
    body.delta_position += h * body.velocity;
    body.delta_rotation = compose(small_rotation(h * body.angular_velocity), body.delta_rotation);
}

}  // namespace

void integrate_velocities(BodyStore& bodies, Vec2 gravity, float h, const SpeedLimits& limits, Crew& crew) {
    TUMBLE_CHECK(bodies.moving.size() == bodies.solver_bodies.size());
    TUMBLE_CHECK(h > 0.0f);
    crew.for_each(bodies.solver_bodies.size(), kLeastIntegrated, [&](std::size_t i) {
        SolverBody& body = bodies.solver_bodies[i];
        if (body.flags & kDynamicBody) integrate_velocity(body, bodies.moving[i], gravity, h, limits);
    });
}

void integrate_positions(BodyStore& bodies, float h, const SpeedLimits& limits, Crew& crew) {
    crew.for_each(bodies.solver_bodies.size(), kLeastIntegrated, [&](std::size_t i) {
        if (i != kStaticSolverBody) integrate_position(bodies.solver_bodies[i], h, limits);
    });
}

}  // namespace tumble
