// Bodies that nothing touches move exactly: along the parabola of a constant acceleration, or with damping along its
// closed form, at any length of step.
#pragma once

#include "dynamics/state/simulation.hpp"

namespace tumble {

// A stage of the step, before the sub-steps: stores the velocities, and marks the joined bodies alone as pushed.
void begin_flight(Simulation& simulation);

// A stage of the step, after the sub-steps: replaces the motion of the bodies that no contact or joint has pushed.
void end_flight(Simulation& simulation);

}  // namespace tumble
