// All faces of A - B at once: an edge of a small core in each lane, without a branch.
#pragma once

#include <limits>
#include <utility>

#include "debug/check.hpp"
#include "narrow/cores/turned_core.hpp"

namespace tumble {

// The faces of one core's edges. Lane i is the edge from vertex i to the next one.
template <int N>
struct FaceLanes {
    DoubleLanes<N> outward_x;  // normal to the edge, as long as it
    DoubleLanes<N> outward_y;
    DoubleLanes<N> length;
    DoubleLanes<N> separation;  // of the cores along it; minus infinity for lanes without an edge
    DoubleLanes<N> nearest;     // the other core's vertex nearest to the face, the lowest index of equals
};

template <int N, std::size_t... Vertex>
TUMBLE_LANE_FUNCTION LowestLanes<N> lowest_heights(const DoubleLanes<N>& x, const DoubleLanes<N>& y,
                                                   const TurnedCore<N>& other, std::index_sequence<Vertex...>) {
    LowestLanes<N> lowest{x * spread<0>(other.x) + y * spread<0>(other.y)};
    (take_lower(lowest, x * spread<Vertex + 1>(other.x) + y * spread<Vertex + 1>(other.y), Vertex + 1), ...);
    return lowest;
}

// The formulas of a face, with a face in each lane: either the edges of one core, all turned by its rotation, or one
// edge of each of many pairs, with a rotation in each lane.
template <int N, typename Rotations>
TUMBLE_LANE_FUNCTION DoubleLanes<N> outward_x_of(const Rotations& c, const Rotations& s, const DoubleLanes<N>& edge_x,
                                                 const DoubleLanes<N>& edge_y) {
    return s * edge_x + c * edge_y;
}

template <int N, typename Rotations>
TUMBLE_LANE_FUNCTION DoubleLanes<N> outward_y_of(const Rotations& c, const Rotations& s, const DoubleLanes<N>& edge_x,
                                                 const DoubleLanes<N>& edge_y) {
    return s * edge_y - c * edge_x;
}

// The separation along the outward normal (x, y), from the other core's lowest height and the edge's first end; minus
// infinity for an edge without length. That is decided by the square of the length, which is known long before the
// root.
template <int N, typename Offset>
TUMBLE_LANE_FUNCTION DoubleLanes<N> separation_along(const DoubleLanes<N>& x, const DoubleLanes<N>& y,
                                                     const DoubleLanes<N>& length_sq, const DoubleLanes<N>& length,
                                                     const DoubleLanes<N>& lowest, const DoubleLanes<N>& own_x,
                                                     const DoubleLanes<N>& own_y, const Offset& offset_x,
                                                     const Offset& offset_y) {
    const DoubleLanes<N> none(-std::numeric_limits<double>::infinity());
    const DoubleLanes<N> gap = (lowest - (x * own_x + y * own_y)) + (offset_x * x + offset_y * y);
    return select(DoubleLanes<N>(0.0) < length_sq, gap / length, none);
}

// The offset is from the owner's position to the other core's. A circle has no faces: returning at once saves 5 of 47
// ns.
template <int N>
TUMBLE_LANE_FUNCTION FaceLanes<N> faces_of(const Core& owner, const TurnedCore<N>& own, const TurnedCore<N>& other,
                                           double offset_x, double offset_y) {
    const DoubleLanes<N> none(-std::numeric_limits<double>::infinity());
    if (owner.count == 1) return {none, none, none, none, none};
    TUMBLE_CHECK(owner.count > 1);
    TUMBLE_CHECK(owner.count <= N);
    const DoubleLanes<N> local_x = load_widened<N>(owner.x), local_y = load_widened<N>(owner.y);
    const DoubleLanes<N> edge_x = next_lanes(local_x) - local_x, edge_y = next_lanes(local_y) - local_y;
    const DoubleLanes<N> x = outward_x_of(owner.c, owner.s, edge_x, edge_y),
                         y = outward_y_of(owner.c, owner.s, edge_x, edge_y);
    const LowestLanes<N> lowest = lowest_heights(x, y, other, std::make_index_sequence<N - 1>());
    const DoubleLanes<N> length_sq = x * x + y * y, length = square_root(length_sq);
    return {x, y, length, separation_along(x, y, length_sq, length, lowest.value, own.x, own.y, offset_x, offset_y),
            lowest.index};
}

}  // namespace tumble
