// The plot of both bounds on the distance over the iterations of GJK.
#pragma once

#include <vector>

#include "render/drawing/panel.hpp"
#include "tumble/distance.hpp"

namespace tumble::render {

// Draws a panel of its own. Needs at least two steps.
void draw_bounds_panel(Drawing& drawing, PixelRect rect, const std::vector<TraceStep>& steps);

}  // namespace tumble::render
