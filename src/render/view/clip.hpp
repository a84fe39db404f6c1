// Cutting what is far larger than the frame down to it, in double, before pixels become float.
#pragma once

#include <vector>

#include "render/view/view.hpp"

namespace tumble::render {

// How far beyond the frame's edges frames are cut (pixels), on top of a line's width: far enough that neither a cut nor
// its outline is seen.
inline constexpr double kClipMargin = 64.0;

// Cuts a segment to the frame grown by `margin` pixels; false if nothing is left. Liang and Barsky 1984.
bool clip_segment(const View& view, double margin, DVec2& from, DVec2& to);

// Cuts a convex polygon to the frame grown by `margin` pixels. Sutherland and Hodgman 1974.
std::vector<DVec2> clip_polygon(const View& view, double margin, std::vector<DVec2> polygon);

}  // namespace tumble::render
