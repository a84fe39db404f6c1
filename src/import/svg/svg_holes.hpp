// Areas with holes as polygons without holes.
#pragma once

#include <optional>
#include <vector>

#include "tumble/math.hpp"

namespace tumble::scene {

// A closed line without crossings; the last point joins the first.
using Ring = std::vector<DVec2>;

// Twice the area, positive if the ring is counter-clockwise.
double twice_area_of(const Ring& ring);

// The number of counter-clockwise turns of the ring around the point: 1, 0 or -1.
int winding_number(const Ring& ring, DVec2 point);

// The area inside `outer` and outside of `holes`, as simple counter-clockwise polygons. The coordinates are float
// values and stay so. Cuts along the line x = c through the middle of a hole, until none is left. Each piece lies on
// one side of a cut, and pieces meet in equal points. `outer` is counter-clockwise, the holes are clockwise, inside it
// and apart. Empty if a hole is too narrow for a cut, or if the rings cross.
std::optional<std::vector<Ring>> cut_open(const Ring& outer, const std::vector<Ring>& holes);

}  // namespace tumble::scene
