// Convex parts from triangles.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "shape/triangulate.hpp"

namespace tumble {

// Removes each diagonal whose two sides together are a convex part of at most `max_vertices` corners. The parts are
// rings of corners, counter-clockwise, straight corners included; at most four times the least possible number.
std::vector<std::vector<std::size_t>> merge_triangles(const Ring& ring, std::span<const Triangle> triangles,
                                                      std::size_t max_vertices);

}  // namespace tumble
