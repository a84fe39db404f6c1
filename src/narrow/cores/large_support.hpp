// The support vertex of a large polygon: the first edge that does not rise in the direction, by the directions of the
// edges in angular order. It is looked for beside a vertex that is likely to be near, the hill climbing of [Cam97] kept
// from walking around the polygon: after a few steps a table of sectors of the circle (edges_before) and bisection in
// one take over.
#pragma once

#include "narrow/cores/core_pair.hpp"

namespace tumble {

// By the direction in the polygon's own frame; `near` is any vertex. The answer does not depend on it: 5 ns where it is
// within a few vertices, 19 ns elsewhere. Only where the polygon has its edge angles.
int large_support(const LargePolygon& polygon, DVec2 direction, int near);

}  // namespace tumble
