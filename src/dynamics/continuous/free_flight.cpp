#include "dynamics/continuous/free_flight.hpp"

#include <cmath>

#include "debug/check.hpp"

namespace tumble {

namespace {

// The solution of v' = a - c v, where v is the velocity at the start, c the damping and a the acceleration. After the
// time t, with z = c t:
//   v(t) = decay v + gain a t,  x(t) = gain v t + sag a t^2
// where decay = e^-z, gain = (1 - e^-z) / z and sag = (1 - gain) / z.
struct Flight {
    double decay = 1.0, gain = 1.0, sag = 0.5;
};

// For z <= 1/2 the sum of 14 terms of the series of sag has an error below 1e-17. For greater z the flight is that of
// half the time, twice.
Flight make_flight(double z) {
    TUMBLE_CHECK(z >= 0.0);
    if (z == 0.0) return {};
    if (z > 0.5) {
        const Flight half = make_flight(0.5 * z);
        return {half.decay * half.decay, 0.5 * half.gain * (1.0 + half.decay),
                0.25 * (2.0 * half.sag + half.gain * half.gain)};
    }
    double sag = 0.0;
    for (int n = 14; n >= 2; --n) sag = (1.0 - z * sag) / n;
    const double gain = 1.0 - z * sag;
    return {1.0 - z * gain, gain, sag};
}

// `rest` is what rounding to float took from a velocity at the end of the last step. It is dropped if the velocity has
// been set since then, which is so if `rest` exceeds half a unit in the last place.
double rest_of(float velocity, float rest) {
    return std::abs(rest) <= 0x1p-24f * std::abs(velocity) ? static_cast<double>(rest) : 0.0;
}

void fly(Simulation& simulation, std::size_t index) {
    TUMBLE_CHECK(index < simulation.scratch->start_velocities.size());
    SolverBody& body = simulation.bodies.solver_bodies[index];
    MovingBody& moving = simulation.bodies.moving[index];
    const double t = static_cast<double>(simulation.settings.duration);
    const Flight flight = make_flight(t * static_cast<double>(moving.motion.linear_damping));
    const DVec2 start = simulation.scratch->start_velocities[index].linear;
    const DVec2 acceleration(
        simulation.bodies.free_acceleration(static_cast<std::uint32_t>(index), simulation.settings.gravity));
    const DVec2 velocity = flight.decay * start + (flight.gain * t) * acceleration;
    body.velocity = to_float(velocity);
    moving.velocity_rest = to_float(velocity - DVec2(body.velocity));
    body.delta_position = to_float((flight.gain * t) * start + (flight.sag * t * t) * acceleration);
}

void spin(Simulation& simulation, std::size_t index) {
    SolverBody& body = simulation.bodies.solver_bodies[index];
    const MovingBody& moving = simulation.bodies.moving[index];
    const double t = static_cast<double>(simulation.settings.duration);
    const Flight flight = make_flight(t * static_cast<double>(moving.motion.angular_damping));
    const double start = static_cast<double>(simulation.scratch->start_velocities[index].angular);
    const double acceleration = static_cast<double>(allowed(body.flags, moving.angular_acceleration));
    body.angular_velocity = static_cast<float>(flight.decay * start + flight.gain * t * acceleration);
    body.delta_rotation = make_rotation(flight.gain * t * start + flight.sag * t * t * acceleration);
}

}  // namespace

void begin_flight(Simulation& simulation) {
    BodyStore& bodies = simulation.bodies;
    std::vector<StartVelocity>& start = simulation.scratch->start_velocities;
    start.resize(bodies.solver_bodies.size());
    for (std::size_t i = 1; i < start.size(); ++i) {
        SolverBody& body = bodies.solver_bodies[i];
        body.flags &= ~std::uint32_t{kPushedBody};
        Vec2& rest = bodies.moving[i].velocity_rest;
        const DVec2 exact{rest_of(body.velocity.x, rest.x), rest_of(body.velocity.y, rest.y)};
        start[i] = {DVec2(body.velocity) + exact, body.angular_velocity};
        rest = {};
    }
    simulation.joints.for_each_awake_pair([&](std::uint32_t a, std::uint32_t b, bool) {
        for (const std::uint32_t body : {a, b})
            bodies.solver_bodies[bodies.frames[body].solver_body].flags |= kPushedBody;
    });
}

void end_flight(Simulation& simulation) {
    const BodyStore& bodies = simulation.bodies;
    TUMBLE_CHECK(simulation.scratch->start_velocities.size() == bodies.solver_bodies.size());
    TUMBLE_CHECK(bodies.moving.size() == bodies.solver_bodies.size());
    const float limit = simulation.settings.speed_limits().spin;
    for (std::size_t i = 1; i < bodies.solver_bodies.size(); ++i) {
        const std::uint32_t flags = bodies.solver_bodies[i].flags;
        if (!(flags & kDynamicBody) || (flags & (kPushedBody | kClampedBody))) continue;
        const MovingBody& moving = bodies.moving[i];
        fly(simulation, i);
        const bool changes = moving.motion.angular_damping > 0.0f || moving.angular_acceleration != 0.0f;
        if (changes && std::abs(bodies.solver_bodies[i].angular_velocity) < limit) spin(simulation, i);
    }
}

}  // namespace tumble
