// Whether a ring of points is a simple polygon.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>

#include "shape/sweep_order.hpp"

namespace tumble {

// Two edges that share a point which is not their common end, lower index first; nothing if the ring is simple.
// Consecutive points differ. Exact, O(n log n).
std::optional<std::pair<std::size_t, std::size_t>> find_crossing(const Ring& ring);

}  // namespace tumble
