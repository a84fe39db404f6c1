// Path data: the d attribute.
#pragma once

#include <string_view>

#include "import/svg/svg_flatten.hpp"

namespace tumble::scene {

// All commands of SVG 1.1, 8.3, in both cases. Throws SvgError.
void read_path(std::string_view data, Flattener& out);

// The arc of the path command from one point to another: half axes rx and ry (> 0, enlarged if they are too short to
// reach), the first turned by `degrees`. The points differ.
EllipseArc make_arc(DVec2 from, DVec2 to, double rx, double ry, double degrees, bool large, bool sweep);

}  // namespace tumble::scene
