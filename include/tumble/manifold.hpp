// Contact manifolds: at most two points at which two shapes push each other, from the features that GJK ends with.
#pragma once

#include <cstdint>

#include "tumble/chain.hpp"
#include "tumble/distance.hpp"
#include "tumble/math.hpp"
#include "tumble/shape.hpp"

namespace tumble {

struct ManifoldPoint {
    Vec2 anchor_a;              // m, world axes, from A's position to the point half way between the surfaces
    Vec2 anchor_b;              // the same point from B's position
    float separation = 0.0f;    // m, along the normal, negative if the shapes overlap
    std::uint32_t feature = 0;  // names the vertices and edges that touch; unique within a manifold
};

struct Manifold {
    int point_count = 0;      // 0 to 2; 0 if farther apart than the speculative distance, or for invalid input
    Vec2 normal;              // unit, from A to B, world axes
    ManifoldPoint points[2];  // [point_count], in the counter-clockwise order of A's edge
};

// The manifold of two shapes whose surfaces are at most `speculative_distance` apart (m, >= 0); points farther apart
// are left out. Two corners give one point, with a normal that turns smoothly as they move. Two edges are clipped
// against each other and give up to two points. `cache` is that of the same pair's last call: it warm starts the
// distance query, and keeps the reference edge until another is better by more than a fiftieth of the speculative
// distance. Does not throw or allocate.
Manifold collide(const Shape& a, const Pose& world_from_a, const Shape& b, const Pose& world_from_b,
                 double speculative_distance, SimplexCache& cache) noexcept;

// The manifold of a chain's segment A and a shape B, as collide() gives it, but with a normal that the whole chain has.
// The normal points to the side of the chain that B's middle is on. Around a round corner it turns no farther than to
// the neighbour's normal; beyond that the contact is the neighbour's, and the manifold is empty. At a flat corner
// (within 0.01 rad) or a hollow one the segment's own normal replaces a normal that leans towards the corner, and
// points beyond the segment's end are left to the neighbour.
//
// Empty if B's middle is behind a one-sided segment. If A does not have two different vertices, the result is that of
// collide(). `speculative_distance` (m, >= 0) and `cache` are those of collide(). Does not throw or allocate.
Manifold collide_link(const Shape& a, const ChainLink& link, const Pose& world_from_a, const Shape& b,
                      const Pose& world_from_b, double speculative_distance, SimplexCache& cache) noexcept;

// True if the segment is one-sided and B's middle is on its solid side.
bool is_behind(const Shape& a, const ChainLink& link, const Pose& world_from_a, const Shape& b,
               const Pose& world_from_b);

}  // namespace tumble
