// Continuous collision: a body that moves far in a step stops at its first impact.
//
// Fast bodies are those that move by more than half of the smallest extent of their shapes (kContinuousPart). They are
// swept against static and kinematic bodies, bullets against dynamic ones too, with the time of impact of the narrow
// phase.
//
// Left out: the rest of the step. A stopped body stays at the point of impact until the next step; the contact begins
// in this step and is solved in the next one.
#pragma once

#include "dynamics/state/simulation.hpp"

namespace tumble {

// A stage of the step, before poses are final: shortens the motion of bodies with an impact, and collects the sensors
// near the paths of fast bodies.
void stop_at_impacts(Simulation& simulation);

}  // namespace tumble
