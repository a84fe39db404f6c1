// Motion of the bodies within a sub-step: semi-implicit Euler.
#pragma once

#include "dynamics/bodies/body_store.hpp"
#include "dynamics/bodies/speed_limits.hpp"
#include "tasks/crew.hpp"
#include "tumble/math.hpp"

namespace tumble {

// Dynamic bodies of a range without the static one: v += h (g + F / m), then the damping v / (1 + h c) and the speed
// limits, so that constraints propagate no more speed than a body may have. Other bodies keep their velocities. `h` is
// the sub-step, s.
void integrate_velocities(BodyStore& bodies, const BodyRange& range, Vec2 gravity, float h, const SpeedLimits& limits,
                          Crew& crew);

// Advances the deltas of position and rotation of such a range by the velocities. The speed limits apply before: at the
// speeds that contradictory joints may give in a sub-step, the bodies would end farther apart than they were.
void integrate_positions(BodyStore& bodies, const BodyRange& range, float h, const SpeedLimits& limits, Crew& crew);

}  // namespace tumble
