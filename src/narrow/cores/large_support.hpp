// The support vertex of a large polygon: the start of the first edge that does not rise in the direction, found by the
// edges' angular order. The search starts at a vertex that is likely to be near, as in the hill climbing of
// [Cam97]. If a few steps do not find the edge, a table of sectors of the circle (edges_before) and bisection within
// one sector find it, so that the search never walks around the polygon.
#pragma once

#include "narrow/cores/core_pair.hpp"

namespace tumble {

// The direction is in the polygon's own frame; the polygon must have edge angles. `near` is any vertex and affects the
// time alone: 5 ns if it is within a few vertices of the answer, 19 ns elsewhere.
int large_support(const LargePolygon& polygon, DVec2 direction, int near);

}  // namespace tumble
