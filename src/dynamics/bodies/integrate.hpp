// Motion of the bodies: semi-implicit Euler within the sub-steps, and the new poses at the end of the step.
#pragma once

#include "dynamics/bodies/body_store.hpp"
#include "tumble/math.hpp"

namespace tumble {

struct SpeedLimits {
    float speed = 0.0f;      // m/s
    float spin = 0.0f;       // rad/s
    float fast_spin = 0.0f;  // of bodies that may turn fast, and what nothing passes unless it is thrown
};

// The square of the speed after a way along a constant acceleration; negative if that is out of reach. The scheme keeps
// v^2 - 2 a x exactly for the velocities of the middle of a sub-step, v + a h / 2.
template <class Real>
Real speed_sq_after(const Real& velocity, const Real& way, const Real& acceleration) {
    return velocity * velocity + 2.0f * acceleration * way;
}

// v += h (g + F / m), damping v / (1 + h c), speed limits: constraints are to pass on no more than a body may have.
// Bodies that are not dynamic keep their velocities.
void integrate_velocities(BodyStore& bodies, Vec2 gravity, float h, const SpeedLimits& limits);

// Deltas of position and rotation by the new velocities, within the speed limits: what contradictory joints ask for in
// a sub-step would tear them farther apart than they were.
void integrate_positions(BodyStore& bodies, float h, const SpeedLimits& limits);

struct StepTimes {
    float step = 0.0f;     // s
    float substep = 0.0f;  // s
};

// Ends a body's motion of this step at a fraction: gravity, forces and torques did not act for the rest of it. If the
// body was struck on its way, taking off the speed that they gave would gain energy: along them it gets the speed that
// is due at that place, and what the place is worth beyond that is paid by the spin. A body that is stopped at once
// does not spin: it would be stopped so in every step, by what no contact sees.
void shorten_motion(BodyStore& bodies, std::uint32_t body, double fraction, Vec2 gravity, const StepTimes& times);

// Takes the deltas into the poses and clears them, with the forces that made them. No body ends a step faster than the
// speed limits: joints that contradict each other may have thrown it.
void finalize_poses(BodyStore& bodies, const SpeedLimits& limits);

// The lowest body index whose velocity or position is not finite, or kNoBody.
inline constexpr std::uint32_t kNoBody = 0xffffffffu;
std::uint32_t find_diverged(const BodyStore& bodies);

}  // namespace tumble
