// Walks every invariant that the stores promise each other; for tests and for hunting defects.
#pragma once

#include "dynamics/state/simulation.hpp"

namespace tumble {

// Throws std::logic_error that names the first invariant broken.
void audit(const Simulation& simulation);

}  // namespace tumble
