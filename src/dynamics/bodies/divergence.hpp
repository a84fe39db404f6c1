// Detects that a step did not end in finite numbers.
#pragma once

#include <cmath>
#include <cstdint>

#include "dynamics/bodies/body_store.hpp"

namespace tumble {

inline constexpr std::uint32_t kNoBody = 0xffffffffu;

// False if the velocity or pose of a moving body is NaN or infinite.
inline bool is_finite(const SolverBody& body, const BodyFrame& frame) {
    return is_finite(body.velocity) && std::isfinite(body.angular_velocity) && is_finite(frame.center) &&
           std::isfinite(frame.pose.rotation.c + frame.pose.rotation.s);
}

// True if the static solver body has a velocity: an impulse was not finite.
inline bool has_moved_static(const BodyStore& bodies) {
    const SolverBody& body = bodies.solver_bodies[kStaticSolverBody];
    return !(body.velocity == Vec2{} && body.angular_velocity == 0.0f);
}

// The lowest index of a body whose velocity or pose is not finite, or kNoBody.
//
// If the static solver body has moved, every body that rests on it is lost. In that case: the lowest index of a static
// body with a joint, or of any static body if none has one.
std::uint32_t find_diverged(const BodyStore& bodies);

// Without a finite pose, as after a step that diverged, a body has no boxes.
bool has_finite_pose(const BodyStore& bodies, std::uint32_t body);

}  // namespace tumble
