// The distance of a point from a segment, in double.
#pragma once

#include <algorithm>

#include "tumble/math.hpp"

namespace tumble {

// A segment of equal ends is a point.
inline double segment_distance(Vec2 point, Vec2 from, Vec2 to) {
    const DVec2 edge = DVec2(to) - DVec2(from), offset = DVec2(point) - DVec2(from);
    const double length_sq = dot(edge, edge);
    const double along = length_sq > 0.0 ? std::clamp(dot(offset, edge) / length_sq, 0.0, 1.0) : 0.0;
    return length(offset - along * edge);
}

}  // namespace tumble
