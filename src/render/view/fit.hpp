// What a camera should have in view when the scene does not say.
#pragma once

#include <algorithm>
#include <vector>

#include "render/view/run_ahead.hpp"

namespace tumble::render {

// The box of all that moves or begins on the way, grown by the way down to the ground. What never moves is included
// whole if that takes little more room, else as far as it is near. So are the ways of bodies, but for those that leave
// a frame three times as high as one of the beginning: what is lost or thrown out shrinks nothing. Empty if the world
// is.
Box interesting_box(const World& world, const std::vector<BodyWay>& ways, double aspect_ratio);

// The height of a frame that holds a box of that size.
inline double height_for(DVec2 size, double aspect_ratio) { return std::max(size.y, size.x / aspect_ratio); }

}  // namespace tumble::render
