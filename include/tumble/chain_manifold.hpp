// Contacts with a chain's segments: manifolds without ghost collisions where two segments join, and the solid side.
#pragma once

#include "tumble/chain.hpp"
#include "tumble/distance.hpp"
#include "tumble/manifold.hpp"
#include "tumble/math.hpp"
#include "tumble/shape.hpp"

namespace tumble {

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
