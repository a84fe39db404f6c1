// Clips segments and polygons to the frame, in double, before pixel coordinates become float.
#pragma once

#include <vector>

#include "render/view/view.hpp"

namespace tumble::render {

// Frames are clipped this far beyond their edges (pixels), plus the width of a line: neither the cut nor an outline
// along it is visible.
inline constexpr double kClipMargin = 64.0;

// Clips a segment to the frame grown by `margin` pixels; false if nothing is left. Liang and Barsky 1984.
bool clip_segment(const View& view, double margin, DVec2& from, DVec2& to);

// Clips a convex polygon to the frame grown by `margin` pixels. Sutherland and Hodgman 1974.
std::vector<DVec2> clip_polygon(const View& view, double margin, std::vector<DVec2> polygon);

}  // namespace tumble::render
