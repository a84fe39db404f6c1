// Chains: ground made of segments that store the points beside them, so that shapes slide over their joints smoothly.
// The contacts of a segment are in manifold.hpp.
#pragma once

#include <span>
#include <vector>

#include "tumble/math.hpp"

namespace tumble {

// The chain's points beside a segment, in the segment's coordinates.
struct ChainLink {
    Vec2 before;              // the chain's point before the segment's first
    Vec2 after;               // the chain's point after the segment's second
    bool has_before = false;  // false at an open end, where the segment collides on all sides
    bool has_after = false;
    bool one_sided = false;  // solid on its left: collides with shapes on its right, and others pass through it

    friend constexpr bool operator==(const ChainLink&, const ChainLink&) = default;
};

// The links of a chain's segments, [n - 1] for n points, or [n] if the chain is closed by `loop`. Segment i runs from
// point i to point i + 1. Throws std::invalid_argument for fewer than two points.
std::vector<ChainLink> make_chain_links(std::span<const Vec2> points, bool loop, bool one_sided);

}  // namespace tumble
