// How a shape meets a chain's segment: the manifold, and on which side of the chain it is.
#pragma once

#include <cstdint>

#include "tumble/chain_manifold.hpp"

namespace tumble {

// Where the middle of a shape is that is no farther from a segment than the speculative distance. Both sides of a
// two-sided chain are open.
enum class LinkSide : std::uint8_t { apart, open, solid };

struct LinkMeeting {
    Manifold manifold;  // none on the solid side
    LinkSide side = LinkSide::apart;
};

// As collide_link(), which gives the manifold alone.
LinkMeeting meet_link(const Shape& a, const ChainLink& link, const Pose& world_from_a, const Shape& b,
                      const Pose& world_from_b, double speculative_distance, SimplexCache& cache) noexcept;

}  // namespace tumble
