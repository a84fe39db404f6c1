// What comes from the solid side of a one-sided chain passes it whole: half through, with its middle on the open side
// already, it may drift on to segments that it has not met before, and they would throw it out.
#pragma once

#include "dynamics/state/simulation.hpp"

namespace tumble {

// True if one of the pair is a segment that the other passes, or follows one that it passes with a turn of less than a
// right angle: beyond, the two have no solid side in common. O(segments of the body), where anything passes any chain.
bool passes_chain(const Simulation& simulation, ProxyPair pair);

// A shape that meets a segment for the first time comes from the side from which it has met those next to it: what
// passes goes on to pass, and what they hold but was pressed in past its middle does not begin to.
void keep_side(const Simulation& simulation, Contact& contact);

}  // namespace tumble
