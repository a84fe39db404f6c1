// Shared by the casts: the path with its error bound, and the result for a clipped path.
#pragma once

#include "narrow/cast/cast_clip.hpp"
#include "tumble/cast.hpp"

namespace tumble {

CastResult invalid_cast();

inline CastResult missed(std::int32_t iterations) {
    return {CastStatus::miss, 1.0, 1.0, 1.0, {}, {}, iterations, false};
}

inline CastResult overlapped(std::int32_t iterations) {
    return {CastStatus::overlapping, 0.0, 0.0, 0.0, {}, {}, iterations, false};
}

bool is_valid_motion(DVec2 translation);

// The error bound is that of the core distance with the reach among the sizes. A contact is always near the vertices,
// so the length of the path does not enter.
CastPath make_path(const CorePair& pair, DVec2 translation, double reach);

// Points are those of A's core, moved to its surface by the radius.
CastResult cast_result(const ClippedPath& clipped, const CastPath& path, const Core& a, double radius_a,
                       DVec2 position_a);

}  // namespace tumble
