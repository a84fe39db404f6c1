// Continuous collision: a body that moves far in a step is stopped where it first meets what it must not pass.
//
// Fast is who moves by more than half of the smallest extent of its shapes. Fast bodies are swept against static and
// kinematic ones, bullets against all, on the bracketed time of impact of the narrow phase.
//
// Left out: what a stopped body would have done with the rest of the step. It loses that time: the contact begins in
// this step and is solved in the next.
#pragma once

#include "dynamics/state/simulation.hpp"

namespace tumble {

// A stage of the step, before poses are final: shortens the motion of the bodies that are stopped.
void stop_at_impacts(Simulation& simulation);

}  // namespace tumble
