// Whether the vertices of a small shape are a convex outline. If they are, its edges are the faces of its hull.
#pragma once

#include <span>

#include "tumble/math.hpp"

namespace tumble {

// True if no vertex lies to the right of any edge, decided exactly: the outline is counter-clockwise and winds once;
// collinear and duplicate vertices are allowed. One or two vertices are convex. O(n^2).
bool is_convex_outline(std::span<const Vec2> vertices);

}  // namespace tumble
