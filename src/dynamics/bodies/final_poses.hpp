// Poses at the end of a step, from the deltas that the sub-steps left.
#pragma once

#include "dynamics/bodies/body_store.hpp"
#include "dynamics/bodies/speed_limits.hpp"
#include "tasks/crew.hpp"
#include "tumble/math.hpp"

namespace tumble {

struct StepTimes {
    float step = 0.0f;     // s
    float substep = 0.0f;  // s
};

// Ends the motion of a moving body at a fraction of the step, 0 to 1. Gravity, forces and torques did not act for the
// rest of the step, so the speed that they gave in that time is taken away.
//
// If the body was struck during the step, taking that speed away would gain energy. Its speed along the free
// acceleration a then follows from v^2 - 2 a x at the position where it stops. Where that gives a negative square, the
// missing energy is taken from the spin. A body that is stopped at fraction 0 stops spinning: no contact resolves such
// an impact, and the next steps would repeat it.
void shorten_motion(BodyStore& bodies, std::uint32_t body, double fraction, Vec2 gravity, const StepTimes& times);

// Adds the deltas to the poses, and clears them together with the forces of the step. The speed limits apply to the
// final velocities too: joints that contradict each other may have exceeded them. Returns false if a body is not
// finite, or the static solver body has moved.
bool finalize_poses(BodyStore& bodies, const SpeedLimits& limits, Crew& crew);

}  // namespace tumble
