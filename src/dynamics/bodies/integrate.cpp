#include "dynamics/bodies/integrate.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/bodies/constants.hpp"

namespace tumble {

namespace {

// Rotation composed and made unit again in double, so that the rounding to float is the only error of a step.
Rotation turned(Rotation delta, Rotation q) {
    const double c = double{delta.c} * q.c - double{delta.s} * q.s;
    const double s = double{delta.s} * q.c + double{delta.c} * q.s;
    const double scale = 1.0 / std::sqrt(c * c + s * s);
    return {static_cast<float>(scale * c), static_cast<float>(scale * s)};
}

// Turning faster than `spin` is common and only limited; what is faster than anything may be was thrown.
void limit_speed(SolverBody& body, const SpeedLimits& limits) {
    const bool is_too_fast = length_sq(body.velocity) > limits.speed * limits.speed;
    if (is_too_fast) body.velocity = (limits.speed / length(body.velocity)) * body.velocity;
    if (is_too_fast || std::abs(body.angular_velocity) > limits.fast_spin) body.flags |= kThrownBody;
    const float spin = body.flags & kFastSpin ? limits.fast_spin : limits.spin;
    body.angular_velocity = std::clamp(body.angular_velocity, -spin, spin);
}

// Nothing moves the static solver body but an impulse that is not finite, and then all who rest on it are lost: of the
// bodies that it stands for, the first that a joint holds.
std::uint32_t find_moved_static(const BodyStore& bodies) {
    const SolverBody& body = bodies.solver_bodies[kStaticSolverBody];
    if (body.velocity == Vec2{} && body.angular_velocity == 0.0f) return kNoBody;
    std::uint32_t first = kNoBody;
    for (const BodyId id : bodies.ids.live()) {
        if (bodies.frames[id.index].solver_body != kStaticSolverBody || bodies.is_asleep(id.index)) continue;
        if (!bodies.records[id.index].joints.empty()) return id.index;
        first = std::min(first, id.index);
    }
    return first;
}

}  // namespace

void integrate_velocities(BodyStore& bodies, Vec2 gravity, float h, const SpeedLimits& limits) {
    for (std::size_t i = 1; i < bodies.solver_bodies.size(); ++i) {
        SolverBody& body = bodies.solver_bodies[i];
        if (!(body.flags & kDynamicBody)) continue;
        const MovingBody& moving = bodies.moving[i];
        const BodyMotion& motion = moving.motion;
        const float linear_decay = 1.0f / (1.0f + h * motion.linear_damping);
        const float angular_decay = 1.0f / (1.0f + h * motion.angular_damping);
        const Vec2 velocity = linear_decay * (body.velocity + h * moving.free_acceleration(gravity));
        const float spin = angular_decay * (body.angular_velocity + h * moving.angular_acceleration);
        body.velocity = allowed(body.flags, velocity);
        body.angular_velocity = allowed(body.flags, spin);
        limit_speed(body, limits);
    }
}

void integrate_positions(BodyStore& bodies, float h, const SpeedLimits& limits) {
    for (std::size_t i = 1; i < bodies.solver_bodies.size(); ++i) {
        SolverBody& body = bodies.solver_bodies[i];
        if (body.flags & kDynamicBody) limit_speed(body, limits);
        body.delta_position += h * body.velocity;
        body.delta_rotation = compose(small_rotation(h * body.angular_velocity), body.delta_rotation);
    }
}

void shorten_motion(BodyStore& bodies, std::uint32_t index, double fraction, Vec2 gravity, const StepTimes& times) {
    const BodyFrame& frame = bodies.frames[index];
    SolverBody& body = bodies.solver_bodies[frame.solver_body];
    const MovingBody& moving = bodies.moving[frame.solver_body];
    const float part = static_cast<float>(fraction), rest = static_cast<float>(1.0 - fraction);
    const float lost = rest * times.step;
    body.angular_velocity -= allowed(body.flags, lost * moving.angular_acceleration);
    const Vec2 acceleration = allowed(body.flags, moving.free_acceleration(gravity));
    const float size = length(acceleration);
    if (size > 0.0f) {
        const Vec2 down = (1.0f / size) * acceleration;
        const float fallen = dot(body.delta_position, down), gained = size * times.step;
        const float middle = dot(body.velocity, down) + 0.5f * times.substep * size;
        const float ballistic = middle - lost * size;
        // If not, its mean speed is that of free motion, but for what damping takes.
        const bool was_struck = std::abs(middle - 0.5f * gained - fallen / times.step) > gained;
        const float due_sq = was_struck ? speed_sq_after(middle, -rest * fallen, size) : ballistic * ballistic;
        const float speed = std::min(std::sqrt(std::max(due_sq, 0.0f)), std::abs(middle) + lost * size);
        body.velocity += (std::copysign(speed, ballistic) - middle) * down;
        const float owed = std::min(due_sq, 0.0f) * frame.inv_inertia / frame.inv_mass;
        const float spin_sq = body.angular_velocity * body.angular_velocity + owed;
        body.angular_velocity = std::copysign(std::sqrt(std::max(spin_sq, 0.0f)), body.angular_velocity);
    }
    if (fraction <= 0.0) body.angular_velocity = 0.0f;
    body.delta_position = part * body.delta_position;
    body.delta_rotation = make_rotation(fraction * angle(body.delta_rotation));
}

void finalize_poses(BodyStore& bodies, const SpeedLimits& limits) {
    for (std::size_t i = 1; i < bodies.solver_bodies.size(); ++i) {
        SolverBody& body = bodies.solver_bodies[i];
        const std::uint32_t index = bodies.moving[i].body;
        BodyFrame& frame = bodies.frames[index];
        frame.center += DVec2(body.delta_position);
        if (body.delta_rotation != Rotation{}) {
            frame.pose.rotation = turned(body.delta_rotation, frame.pose.rotation);
            frame.center_offset = rotate(frame.pose.rotation, bodies.records[index].mass.center);
        }
        frame.pose.position = frame.center - DVec2(frame.center_offset);
        body.flags &= ~std::uint32_t{kThrownBody};
        if (body.flags & kDynamicBody) limit_speed(body, limits);
        body.delta_position = {};
        body.delta_rotation = {};
        bodies.moving[i].acceleration = {};
        bodies.moving[i].angular_acceleration = 0.0f;
    }
}

std::uint32_t find_diverged(const BodyStore& bodies) {
    std::uint32_t first = kNoBody;
    for (std::size_t i = 1; i < bodies.solver_bodies.size(); ++i) {
        const SolverBody& body = bodies.solver_bodies[i];
        const BodyFrame& frame = bodies.frames[bodies.moving[i].body];
        const bool finite = is_finite(body.velocity) && std::isfinite(body.angular_velocity) &&
                            is_finite(frame.center) && std::isfinite(frame.pose.rotation.c + frame.pose.rotation.s);
        if (!finite) first = std::min(first, bodies.moving[i].body);
    }
    return first != kNoBody ? first : find_moved_static(bodies);
}

}  // namespace tumble
