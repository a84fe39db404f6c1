// The convex hull of points, exact, then simplified within a tolerance.
#pragma once

#include <span>
#include <vector>

#include "tumble/shape.hpp"

namespace tumble {

// The strictly convex hull, counter-clockwise from the lowest of the leftmost points. Finite points, one or more.
std::vector<Vec2> convex_hull(std::span<const Vec2> points);

// The hull with fewer vertices: each one left out lies within `tolerance` of the result, which may have two vertices
// (from a sliver) or one.
std::vector<Vec2> simplify_hull(const std::vector<Vec2>& hull, double tolerance);

// How many of `points` are vertices of the hull `kept`, near one, near an edge, or inside.
HullReport classify_points(std::span<const Vec2> points, const std::vector<Vec2>& kept, double tolerance);

}  // namespace tumble
