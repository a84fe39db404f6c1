// The exact orientation of three float points.
#pragma once

#include "tumble/math.hpp"

namespace tumble {

// +1 if a, b, c turn counter-clockwise, -1 if clockwise, 0 if they lie on a line; exact for all finite floats.
int orientation(Vec2 a, Vec2 b, Vec2 c);

}  // namespace tumble
