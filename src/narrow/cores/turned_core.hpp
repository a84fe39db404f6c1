// A small core with all its vertices turned into world axes at once, a vertex in each lane.
#pragma once

#include "debug/check.hpp"
#include "narrow/cores/core_pair.hpp"
#include "simd/double_lanes.hpp"

namespace tumble {

// At most N vertices; the lanes after the last one repeat vertex 0. Ties go to the lowest lane, so these are never
// chosen.
template <int N>
struct TurnedCore {
    DoubleLanes<N> x;  // relative to the body's position; the same bits as Core::point()
    DoubleLanes<N> y;
};

template <int N>
TUMBLE_LANE_FUNCTION TurnedCore<N> turn(const Core& core) {
    TUMBLE_CHECK(core.count >= 1);
    TUMBLE_CHECK(core.count <= N);
    const DoubleLanes<N> x = load_widened<N>(core.x), y = load_widened<N>(core.y);
    return {core.c * x - core.s * y, core.s * x + core.c * y};
}

// Both cores, by index: 0 is A, 1 is B.
template <int N>
using TurnedPair = TurnedCore<N>[2];

template <int N>
TUMBLE_LANE_FUNCTION DoubleLanes<N> heights(const TurnedCore<N>& core, double direction_x, double direction_y) {
    return direction_x * core.x + direction_y * core.y;
}

}  // namespace tumble
