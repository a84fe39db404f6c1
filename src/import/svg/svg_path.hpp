// Reads path data, the attribute d.
#pragma once

#include <string_view>

#include "import/svg/svg_flatten.hpp"

namespace tumble::scene {

// Draws all commands of SVG 1.1, 8.3, absolute and relative, into `out`. Throws SvgError.
void read_path(std::string_view data, Flattener& out);

// The arc of the path command A from one point to another, which must differ: half axes rx and ry (> 0, enlarged if
// they are too short to reach), the first rotated by `degrees`.
EllipseArc make_arc(DVec2 from, DVec2 to, double rx, double ry, double degrees, bool large, bool sweep);

}  // namespace tumble::scene
