// Mitre vectors: they offset a line of points sideways so that each edge keeps its direction.
#pragma once

#include <span>
#include <vector>

#include "tumble/math.hpp"

namespace tumble::render {

// The unit normal on the right of the direction from a to b: the outward one for an edge of a counter-clockwise
// outline. Zero if the points coincide.
DVec2 right_normal(DVec2 a, DVec2 b);

// For each point the vector that moves it by 1 to the right of the edges before and after; [points.size()]. The last
// edge of a closed line leads back to its first point. Limited to a length of 4 at sharp corners.
std::vector<DVec2> mitres(std::span<const DVec2> points, bool is_closed);

}  // namespace tumble::render
