// The support vertex of a large polygon in O(log n): a table of sectors of the circle (edges_before), bisection over the
// directions of the edges in one, then a walk by exact neighbours [Cam97: hill climbing], which ends where it begins but for rounding. Climbing alone takes steps in proportion
// to n, but one or two from the support of a direction that is nearly the same.
#pragma once

#include "narrow/core_pair.hpp"

namespace tumble {

// By the direction in the polygon's own frame. Only where the polygon has its edge angles.
int large_support(const LargePolygon& polygon, DVec2 direction);

// The same by steps to the higher neighbour. From a vertex that is lowest, not highest, in the direction it may not find
// its way: start from the support of a direction less than a quarter turn away.
int climb(const LargePolygon& polygon, DVec2 direction, int from);

}  // namespace tumble
