// Ground of several tiles, static or kinematic: shapes slide from one tile to the next without a ghost collision.
//
// A shape that slides over tiles overlaps them slightly, so that the narrow phase finds a contact with the side of the
// next tile. But a shape that rests on the plane of one tile can touch another that does not rise above this plane only
// on the plane itself. Its contact with that tile is removed for the step if it has another normal. Chains store their
// neighbours and need no such rule. Of two faces that form a ridge, both may support a shape, if it is not the same.
#pragma once

#include "dynamics/state/simulation.hpp"

namespace tumble {

// A stage of the step, between collision and the preparation of constraints. Tiles are shapes of at most eight vertices
// on static and kinematic bodies that are not part of a chain. Costs O(n^2) in the tiles that one shape touches.
void smooth_seams(Simulation& simulation);

}  // namespace tumble
