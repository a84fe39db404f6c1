// Exact predicates on float points: their order from left to right, and the orientation of three.
#pragma once

#include "tumble/math.hpp"

namespace tumble {

// From left to right; points of equal x from below upwards.
inline bool is_before(Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

// +1 if a, b, c turn counter-clockwise, -1 if clockwise, 0 if they lie on a line; exact for all finite floats.
int orientation(Vec2 a, Vec2 b, Vec2 c);

}  // namespace tumble
