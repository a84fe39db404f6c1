// Concave outlines as sets of convex shapes.
#pragma once

#include <span>
#include <vector>

#include "tumble/math.hpp"
#include "tumble/shape.hpp"

namespace tumble {

// The convex parts of the region inside a simple polygon, given in either winding; the last point joins the first.
// The parts' vertices are points of the outline, taken bit for bit, and every decision is exact: the parts do not
// overlap, their union is the region, and no two parts that share an edge are convex together. A vertex that lies
// exactly on an edge of its part is left out there. Each part is counter-clockwise and starts at the lowest of its
// leftmost vertices. At most four times as many parts as the least possible number (Hertel, Mehlhorn 1983), or more if
// a part would exceed Shape::kMaxVertices. Equal consecutive points and points on a straight edge are allowed.
//
// Throws std::invalid_argument for a point that is not finite, for an outline without area, and for one whose edges
// cross or touch beyond their common ends: the message names two such edges, edge i going from point i to the next.
// A hole is therefore refused, also one joined to the outline by a bridge of two equal edges. O(n log n).
std::vector<Shape> decompose_outline(std::span<const Vec2> points);

}  // namespace tumble
