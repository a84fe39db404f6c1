// What comes from the solid side of a one-sided chain passes it whole: half through, with its middle on the open side
// already, it may drift on to segments that it has not met before, and they would throw it out.
#pragma once

#include "dynamics/simulation.hpp"

namespace tumble {

// True if one of the pair is a segment that the other passes, or the next to one that it passes.
bool passes_chain(Simulation& simulation, ProxyPair pair);

}  // namespace tumble
