// The memory that a world has allocated.
#pragma once

#include "dynamics/state/simulation.hpp"
#include "tumble/counters.hpp"

namespace tumble {

WorldMemory count_memory(const Simulation& simulation);

}  // namespace tumble
