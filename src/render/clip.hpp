// Cutting what is far larger than the frame down to it, in double, before pixels become float.
#pragma once

#include <vector>

#include "render/view.hpp"

namespace tumble::render {

// How far beyond the frame's edges cuts are made (pixels), on top of a line's width: far enough that neither a cut nor
// its outline is seen.
inline constexpr double kClipMargin = 64.0;

// Cuts a segment to the frame, grown by kClipMargin + width; false if nothing is left. Liang and Barsky 1984.
bool clip_segment(const View& view, double width, DVec2& from, DVec2& to);

// Cuts a convex polygon to the frame, grown by kClipMargin. Sutherland and Hodgman 1974.
std::vector<DVec2> clip_polygon(const View& view, std::vector<DVec2> polygon);

}  // namespace tumble::render
