// Random shapes whose outlines are convex exactly, not only up to rounding: hulls of integer points, scaled by powers
// of two. Also functions that place a shape at a given gap from another, by support vertices and without the narrow
// phase.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "reference/query/pair_query.hpp"
#include "reference/query/random.hpp"

namespace tumble::reference {

struct GridPoint {
    std::int64_t x = 0;
    std::int64_t y = 0;

    friend constexpr auto operator<=>(GridPoint, GridPoint) = default;
};

// Grid coordinates are smaller than this in magnitude: they are exact floats, and their cross products are exact
// integers.
inline constexpr std::int64_t kGridLimit = std::int64_t{1} << 24;

// The convex hull, counter-clockwise from the lowest of the leftmost points, without repeated and collinear points
// (Andrew 1979).
std::vector<GridPoint> convex_hull(std::vector<GridPoint> points);

// The points times (2^x_exponent, 2^y_exponent).
std::vector<Vec2> to_vertices(std::span<const GridPoint> points, int x_exponent, int y_exponent);

// A polygon of 3 to `max_vertices` vertices (rarely a segment), with an extent of about 2^exponent to 2^(exponent + 1)
// metres and its origin inside or near it.
Shape random_polygon(Random& random, int max_vertices, int exponent, double radius = 0.0);

// A box about its origin with sides of about 2^exponent metres.
Shape random_box(Random& random, int exponent, double radius = 0.0);
Shape box(double half_width, double half_height, double radius = 0.0, Vec2 center = {});

// Any kind: circle, capsule, segment, box, polygon of up to 8 vertices, sharp or rounded, of about 2^exponent metres.
Shape random_shape(Random& random, int exponent);

// The core vertex farthest in the direction (world axes), relative to the shape's position.
DVec2 support_point(const Shape& shape, Rotation q, DVec2 direction);

// Moves B so that a vertex of each faces the other along the unit vector `normal` (from A to B): the signed distance
// is `gap` up to the rounding of the position if `gap` is positive, and at most `gap` if it is negative.
void place_vertex_to_vertex(PairQuery& query, DVec2 normal, double gap);
void place_vertex_to_vertex(PairQuery& query, Random& random, double gap);  // along any direction

// Moves B so that a vertex of B faces a random edge of A (A's vertex if it has only one), or at random the reverse.
void place_vertex_to_edge(PairQuery& query, Random& random, double gap);

// Turns B so that an edge of each face each other, parallel up to the rounding of the rotation and then turned by
// `angle`, and moves it to the gap.
void place_edge_to_edge(PairQuery& query, Random& random, double gap, double angle = 0.0);

}  // namespace tumble::reference
