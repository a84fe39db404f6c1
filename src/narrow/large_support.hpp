// The support vertex of a large polygon in O(log n): bisection over the directions of its edges, then a walk by exact
// neighbours [Cam97: hill climbing], which ends where it begins but for rounding.
#pragma once

#include "narrow/core_pair.hpp"

namespace tumble {

// By the direction in the polygon's own frame. Only where the polygon has its edge angles.
int large_support(const LargePolygon& polygon, DVec2 direction);

}  // namespace tumble
