// Motion of the bodies: semi-implicit Euler within the sub-steps, and the new poses at the end of the step.
#pragma once

#include "dynamics/body_store.hpp"
#include "tumble/math.hpp"

namespace tumble {

// v += h (g + F / m), damping v / (1 + h c), speed limits. Bodies that are not dynamic keep their velocities.
void integrate_velocities(BodyStore& bodies, Vec2 gravity, float h, float step_duration);

// Deltas of position and rotation by the new velocities.
void integrate_positions(BodyStore& bodies, float h);

// Takes the deltas into the poses and clears them, with the forces that made them.
void finalize_poses(BodyStore& bodies);

// The lowest body index whose velocity or position is not finite, or kNoBody.
inline constexpr std::uint32_t kNoBody = 0xffffffffu;
std::uint32_t find_diverged(const BodyStore& bodies);

}  // namespace tumble
