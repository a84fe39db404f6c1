// Islands as the API reports them: a number for each body.
#pragma once

#include <vector>

#include "dynamics/state/simulation.hpp"

namespace tumble {

// The island of each live body in id order, -1 if it is not dynamic; see World::islands().
std::vector<int> find_island_numbers(const Simulation& simulation);

}  // namespace tumble
