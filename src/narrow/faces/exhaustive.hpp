// The nearest simplex by exhaustive search, for queries in which GJK stops without one.
#pragma once

#include "narrow/gjk/simplex.hpp"

namespace tumble {

// The edge or vertex of A - B nearest to the origin, over all pairs of a vertex and an edge, O(n m). The boundary of A
// - B is among them, so this is the closest simplex of separated cores. If the outlines are convex and one has more
// than eight vertices, over the boundary alone: O((n + m) log(n + m)) unless most edges are parallel. The simplex is
// empty if every distance is NaN.
Simplex nearest_simplex(const CorePair& pair);

}  // namespace tumble
