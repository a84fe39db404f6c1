// The contact of a shape with a chain's segment: the manifold, and the side of the chain that the shape is on.
#pragma once

#include <cstdint>

#include "tumble/manifold.hpp"

namespace tumble {

// The side of a segment that the middle of a shape is on, for a shape within the speculative distance; else `apart`.
// Both sides of a two-sided chain are open.
enum class LinkSide : std::uint8_t { apart, open, solid };

struct LinkContact {
    Manifold manifold;  // none on the solid side
    LinkSide side = LinkSide::apart;
};

// collide_link() returns the manifold of this alone.
LinkContact find_link_contact(const Shape& a, const ChainLink& link, const Pose& world_from_a, const Shape& b,
                              const Pose& world_from_b, double speculative_distance, SimplexCache& cache) noexcept;

}  // namespace tumble
