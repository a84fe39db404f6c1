// The convex hull of points, exact, then simplified within a tolerance.
#pragma once

#include <span>
#include <vector>

#include "tumble/shape.hpp"

namespace tumble {

// The strictly convex hull, counter-clockwise from the lowest of the leftmost points. Finite points, one or more.
std::vector<Vec2> convex_hull(std::span<const Vec2> points);

// The hull without vertices that it can spare: each one left out lies within `tolerance` of the result. May end with
// two vertices (a sliver) or one (a speck).
std::vector<Vec2> simplify_hull(const std::vector<Vec2>& hull, double tolerance);

// What became of `points` in the hull `kept`.
HullReport classify_points(std::span<const Vec2> points, const std::vector<Vec2>& kept, double tolerance);

}  // namespace tumble
