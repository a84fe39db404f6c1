#include "dynamics/bodies/final_poses.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "debug/check.hpp"
#include "dynamics/bodies/ballistics.hpp"
#include "dynamics/bodies/divergence.hpp"

namespace tumble {

namespace {

// The composed rotation, normalized in double, so that the rounding to float is the only error of a step.
Rotation turned(Rotation delta, Rotation q) {
    const double c = double{delta.c} * q.c - double{delta.s} * q.s;
    const double s = double{delta.s} * q.c + double{delta.c} * q.s;
    const double scale = 1.0 / std::sqrt(c * c + s * s);
    return {static_cast<float>(scale * c), static_cast<float>(scale * s)};
}

}  // namespace

void shorten_motion(BodyStore& bodies, std::uint32_t index, double fraction, Vec2 gravity, const StepTimes& times) {
    TUMBLE_CHECK(fraction >= 0.0);
    TUMBLE_CHECK(fraction <= 1.0);
    const BodyFrame& frame = bodies.frames[index];
    TUMBLE_CHECK(frame.solver_body != kStaticSolverBody);
    SolverBody& body = bodies.solver_bodies[frame.solver_body];
    const MovingBody& moving = bodies.moving[frame.solver_body];
    const float part = static_cast<float>(fraction), rest = static_cast<float>(1.0 - fraction);
    const float rest_time = rest * times.step;  // s
    body.angular_velocity -= allowed(body.flags, rest_time * moving.angular_acceleration);
    const Vec2 acceleration = allowed(body.flags, moving.free_acceleration(gravity));
    const float size = length(acceleration);
    if (size > 0.0f) {
        const Vec2 down = (1.0f / size) * acceleration;
        const float fallen = dot(body.delta_position, down), gained = size * times.step;
        const float middle = dot(body.velocity, down) + 0.5f * times.substep * size;
        const float ballistic = middle - rest_time * size;
        // The mean speed of free motion is middle - gained / 2, apart from damping; an impact changes it by more.
        const bool was_struck = std::abs(middle - 0.5f * gained - fallen / times.step) > gained;
        const float speed_sq = was_struck ? speed_sq_after(middle, -rest * fallen, size) : ballistic * ballistic;
        const float speed = std::min(std::sqrt(std::max(speed_sq, 0.0f)), std::abs(middle) + rest_time * size);
        body.velocity += (std::copysign(speed, ballistic) - middle) * down;
        const float spin_sq_change = std::min(speed_sq, 0.0f) * frame.inv_inertia / frame.inv_mass;
        const float spin_sq = body.angular_velocity * body.angular_velocity + spin_sq_change;
        body.angular_velocity = std::copysign(std::sqrt(std::max(spin_sq, 0.0f)), body.angular_velocity);
    }
    if (fraction <= 0.0) body.angular_velocity = 0.0f;
    body.delta_position = part * body.delta_position;
    body.delta_rotation = make_rotation(fraction * angle(body.delta_rotation));
}

namespace {

constexpr std::size_t kLeastPoses = 256;  // in a chunk: about 3 us of work

// Returns false if the body is not finite.
bool finalize_pose(BodyStore& bodies, std::size_t i, const SpeedLimits& limits) {
    SolverBody& body = bodies.solver_bodies[i];
    const std::uint32_t index = bodies.moving[i].body;
    BodyFrame& frame = bodies.frames[index];
    TUMBLE_CHECK(frame.solver_body == i);
    frame.center += DVec2(body.delta_position);
    if (body.delta_rotation != Rotation{}) {
        frame.pose.rotation = turned(body.delta_rotation, frame.pose.rotation);
        frame.center_offset = rotate(frame.pose.rotation, bodies.moving[i].motion.mass_center);
    }
    frame.pose.position = frame.center - DVec2(frame.center_offset);
    body.flags &= ~std::uint32_t{kClampedBody | kPushedBody};
    if (body.flags & kDynamicBody) clamp_speed(body, limits, spin_limit(body, limits));
    body.delta_position = {};
    body.delta_rotation = {};
    bodies.moving[i].acceleration = {};
    bodies.moving[i].angular_acceleration = 0.0f;
    return is_finite(body, frame);
}

}  // namespace

bool finalize_poses(BodyStore& bodies, const SpeedLimits& limits, Crew& crew) {
    std::atomic<bool> all_finite = !has_moved_static(bodies);
    crew.for_each_chunk(bodies.solver_bodies.size(), kLeastPoses, [&](const Chunk& chunk) {
        bool finite = true;
        for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
            bodies.prefetch_frame_after(i);
            if (i != kStaticSolverBody) finite &= finalize_pose(bodies, i, limits);
        }
        if (!finite) all_finite.store(false, std::memory_order_relaxed);
    });
    return all_finite;
}

}  // namespace tumble
