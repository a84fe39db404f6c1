// The triangles of a simple polygon.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "shape/sweep_order.hpp"

namespace tumble {

using Triangle = std::array<std::size_t, 3>;  // indices into the ring, counter-clockwise

// n - 2 triangles whose corners are corners of the ring. It must be simple, counter-clockwise and without straight
// corners (see find_crossing()). Exact, O(n log n).
std::vector<Triangle> triangulate(const Ring& ring);

}  // namespace tumble
