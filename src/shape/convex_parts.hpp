// Convex parts from triangles.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "shape/triangulate.hpp"

namespace tumble {

// Removes diagonals while the two sides of one make a convex part of at most `max_vertices` corners. The parts are
// rings of corners, counter-clockwise, straight corners included. At most four times the least number of parts.
std::vector<std::vector<std::size_t>> merge_triangles(const Ring& ring, std::span<const Triangle> triangles,
                                                      std::size_t max_vertices);

}  // namespace tumble
