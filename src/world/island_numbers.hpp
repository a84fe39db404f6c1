// Islands as a user sees them: a number for each body.
#pragma once

#include <vector>

#include "dynamics/state/simulation.hpp"

namespace tumble {

// [bodies.ids.live().size()]; see World::islands().
std::vector<int> find_island_numbers(const Simulation& simulation);

}  // namespace tumble
