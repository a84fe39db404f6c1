// Speed limits of bodies.
#pragma once

#include <algorithm>
#include <cmath>

#include "debug/check.hpp"
#include "dynamics/bodies/solver_body.hpp"
#include "tumble/math.hpp"

namespace tumble {

struct SpeedLimits {
    float speed = 0.0f;      // m/s
    float spin = 0.0f;       // rad/s
    float fast_spin = 0.0f;  // rad/s, of bodies with kFastSpin; a body that exceeds it is marked as clamped
};

// The angular speed at which a body may turn, rad/s.
inline float spin_limit(const SolverBody& body, const SpeedLimits& limits) {
    return body.flags & kFastSpin ? limits.fast_spin : limits.spin;
}

// Clamps the velocities of a body; the angular speed to `spin`, rad/s. Rotation beyond its limit is common and only
// limited; a body beyond `speed` or `fast_spin` gets kClampedBody.
inline void clamp_speed(SolverBody& body, const SpeedLimits& limits, float spin) {
    TUMBLE_CHECK(limits.speed > 0.0f);
    TUMBLE_CHECK(limits.spin <= limits.fast_spin);
    const bool is_too_fast = length_sq(body.velocity) > limits.speed * limits.speed;
    if (is_too_fast) body.velocity = (limits.speed / length(body.velocity)) * body.velocity;
    if (is_too_fast || std::abs(body.angular_velocity) > limits.fast_spin) body.flags |= kClampedBody;
    body.angular_velocity = std::clamp(body.angular_velocity, -spin, spin);
}

}  // namespace tumble
