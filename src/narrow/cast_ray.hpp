// Rays that are clear cases: the start outside by more than the error bound, and the entry, if any, not at a vertex.
// Everything else is left to the general clipping, so that no doubtful case is decided twice.
#pragma once

#include "narrow/cast_result.hpp"

namespace tumble {

enum class RayOutcome : std::uint8_t { unclear, misses, enters };

struct RayEntry {
    RayOutcome outcome = RayOutcome::unclear;
    CastContact contact{};  // if it enters
};

// For a shape of one vertex; B is the ray's origin.
RayEntry enter_lone_circle(const CorePair& pair, const CastPath& path);

// For 3 to 8 vertices in the padded arrays of a Shape, and a reach of 0.
RayEntry enter_sharp_polygon(const CorePair& pair, const CastPath& path);

}  // namespace tumble
