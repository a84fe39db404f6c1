// Ground of several tiles, static or kinematic: shapes slide from one tile to the next without a ghost collision.
//
// A shape that slides over tiles overlaps them slightly, so that the narrow phase finds a contact with the side of the
// next tile. But a tile that does not rise above the plane of another can touch a shape that rests on this plane only
// on the plane itself. The contact with that tile is removed for the step if it has another normal. Chains store their
// neighbours and need no such rule.
//
// Only contacts of the same shape are compared: at a ridge each face is below the plane of the other, and a body of two
// shapes may rest on both faces.
#pragma once

#include "dynamics/state/simulation.hpp"

namespace tumble {

// A stage of the step, between collision and the preparation of constraints. Tiles are shapes of at most eight vertices
// on static and kinematic bodies that are not part of a chain. Costs O(n^2) in the tiles that one shape touches.
void smooth_seams(Simulation& simulation);

}  // namespace tumble
