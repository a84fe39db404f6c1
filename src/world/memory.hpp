// The memory that a world has allocated: the sum of the capacities of its vectors.
#pragma once

#include "dynamics/state/simulation.hpp"
#include "tumble/counters.hpp"

namespace tumble {

WorldMemory count_memory(const Simulation& simulation);

}  // namespace tumble
