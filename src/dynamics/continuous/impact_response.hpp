// What an impact does: the impulses on its two bodies and on those that touch them.
#pragma once

#include "dynamics/state/simulation.hpp"

namespace tumble {

// Solves an impact together with the contacts through which it goes on, and changes the motions of the bodies.
// scratch.impacts.members lists these.
void respond(Simulation& simulation, const NextImpact& impact);

}  // namespace tumble
