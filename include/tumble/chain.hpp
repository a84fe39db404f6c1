// Chains: grounds made of segments that know their neighbours, so that what slides over them meets no seams.
#pragma once

#include <span>
#include <vector>

#include "tumble/distance.hpp"
#include "tumble/manifold.hpp"
#include "tumble/math.hpp"
#include "tumble/shape.hpp"

namespace tumble {

// What a segment of a chain knows of the points beside its own, in its own coordinates.
struct ChainLink {
    Vec2 before;              // the chain's point before the segment's first
    Vec2 after;               // and the one after its second
    bool has_before = false;  // false at an open end, where the segment is met from all around
    bool has_after = false;
    bool one_sided = false;  // solid on the left: met from the right; what comes from the left passes whole

    friend constexpr bool operator==(const ChainLink&, const ChainLink&) = default;
};

// The links of the segments that make_chain() gives, [n - 1], or [n] if closed. Two points or more, else an error.
std::vector<ChainLink> make_chain_links(std::span<const Vec2> points, bool loop, bool one_sided);

// The manifold of a chain's segment A and a shape B, as collide() gives it, without the normals that only a lone
// segment would have: on the side of the chain that B's middle is on, and around a corner no farther than to the
// neighbour's normal. At a corner that is flat (0.01 rad) or hollow the segment's own normal stands for all that lean
// towards it; what lies beyond its end is left to the neighbour. Nothing for a B whose middle is behind a one-sided
// segment. An A of other than two vertices is collided without its link.
Manifold collide_link(const Shape& a, const ChainLink& link, const Pose& world_from_a, const Shape& b,
                      const Pose& world_from_b, double speculative_distance, SimplexCache& cache) noexcept;

// True if a one-sided segment lets B pass: its middle is on the solid side.
bool is_behind(const Shape& a, const ChainLink& link, const Pose& world_from_a, const Shape& b,
               const Pose& world_from_b);

}  // namespace tumble
