// The nearest simplex by looking at all: what answers when GJK stops without one.
#pragma once

#include "narrow/gjk/simplex.hpp"

namespace tumble {

// The edge or vertex of A - B nearest to the origin, over all pairs of a vertex and an edge, O(n m): the boundary of A
// - B is among them, so that for separated cores this is the closest simplex. Over that boundary alone, O((n + m) log(n
// + m)) but where all is level, if the outlines are convex and one has more than eight vertices. No simplex if no
// distance is a number.
Simplex nearest_simplex(const CorePair& pair);

}  // namespace tumble
