// Contact manifolds: at most two points that keep two shapes apart, found from the features GJK ends with.
#pragma once

#include <cstdint>

#include "tumble/distance.hpp"
#include "tumble/math.hpp"
#include "tumble/shape.hpp"

namespace tumble {

struct ManifoldPoint {
    Vec2 anchor_a;              // from A's position to the contact, half way between the surfaces, world axes (m)
    Vec2 anchor_b;              // the same contact from B's position
    float separation = 0.0f;    // along the normal, negative inside (m)
    std::uint32_t feature = 0;  // the same while the same vertices and edges meet; unique within a manifold
};

struct Manifold {
    Vec2 normal;              // unit, from A to B, world axes
    int point_count = 0;      // 0: farther apart than the speculative distance, or invalid
    ManifoldPoint points[2];  // in the counter-clockwise order of A's edge
};

// The manifold of two shapes whose surfaces are at most `speculative_distance` apart (m, >= 0); points farther apart
// than that are left out. Two corners meet in one point with a normal that turns smoothly; an edge is clipped against
// the other shape's, into two. Does not throw or allocate. `cache` warms the distance query and keeps the reference
// edge until another is better by more than a fiftieth of the speculative distance.
Manifold collide(const Shape& a, const Pose& world_from_a, const Shape& b, const Pose& world_from_b,
                 double speculative_distance, SimplexCache& cache) noexcept;

}  // namespace tumble
