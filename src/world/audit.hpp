// Checks every invariant of the stores of a world and between them. For tests, and to find defects.
#pragma once

#include "dynamics/state/simulation.hpp"

namespace tumble {

// Throws std::logic_error that names the first broken invariant.
void audit(const Simulation& simulation);

}  // namespace tumble
