// The faces of many pairs of small cores at once, a pair a lane: the formulas of face_lanes.hpp, turned by a quarter.
#pragma once

#include <limits>
#include <utility>

#include "narrow/small_features.hpp"
#include "simd/gather_columns.hpp"

namespace tumble {

// Cores of at most N vertices, and as many pairs at once: of boxes eight at once take a tenth longer than four, of octagons
// four a tenth longer than eight.
template <int N>
using PairLanes = DoubleLanes<N>;

// One core of each pair.
template <int N>
struct CoreOfPairs {
    PairLanes<N> c, s;
    PairLanes<N> local_x[N], local_y[N];
    PairLanes<N> x[N], y[N];  // turned, relative to the body's position

    CoreOfPairs(const Shape* const (&shapes)[N], const Pose* const (&poses)[N]) {
        double cosines[N], sines[N];
        const float *rows_x[N], *rows_y[N];
        for (int lane = 0; lane < N; ++lane) {
            cosines[lane] = poses[lane]->rotation.c;
            sines[lane] = poses[lane]->rotation.s;
            rows_x[lane] = shapes[lane]->x().data();
            rows_y[lane] = shapes[lane]->y().data();
        }
        c = load_lanes(cosines);
        s = load_lanes(sines);
        for (int from = 0; from < N; from += 4) {
            gather_columns(rows_x, from, local_x);
            gather_columns(rows_y, from, local_y);
        }
        for (int i = 0; i < N; ++i) {
            x[i] = c * local_x[i] - s * local_y[i];
            y[i] = s * local_x[i] + c * local_y[i];
        }
    }
};

// All faces of all pairs: those of A's edges, then those of B's. The offset is from A's position to B's.
template <int N>
class FacesOfPairs {
public:
    TUMBLE_LANE_FUNCTION FacesOfPairs(const CoreOfPairs<N>& a, const CoreOfPairs<N>& b, const PairLanes<N>& offset_x,
                                      const PairLanes<N>& offset_y)
        : cores_{&a, &b} {
        look<0>(a, b, offset_x, offset_y, std::make_index_sequence<N>());
        look<N>(b, a, -1.0 * offset_x, -1.0 * offset_y, std::make_index_sequence<N>());
    }

    // Of the pair in a lane: whether any edge has a length; whether no other face is as far; the face of largest
    // separation, the first of equals.
    bool has_leading(int lane) const { return leading_.value[lane] > -std::numeric_limits<double>::infinity(); }
    bool leads_alone(int lane) const { return leading_.tied[lane] == 0; }
    TUMBLE_LANE_FUNCTION OwnedFace leading(int lane, const CorePair& pair) const {
        const int edge = leading_.index[lane], from = edge % N;
        const unsigned is_b = edge >= N;
        const Core* const owners[2] = {&pair.a, &pair.b};
        const CoreOfPairs<N>&own = *cores_[is_b], &other = *cores_[1 - is_b];
        const int to = owners[is_b]->next(from), nearest = nearest_[edge][lane];
        return {is_b, from, to, nearest, outward_x_[edge][lane], outward_y_[edge][lane], length_[edge][lane],
                leading_.value[lane], own.x[from][lane], own.y[from][lane], own.x[to][lane], own.y[to][lane],
                other.x[nearest][lane], other.y[nearest][lane]};
    }

private:
    // Unrolled: the largest so far, and the lowest, then stay in registers.
    template <int First, std::size_t... Edge>
    TUMBLE_LANE_FUNCTION void look(const CoreOfPairs<N>& own, const CoreOfPairs<N>& other, const PairLanes<N>& offset_x,
                                   const PairLanes<N>& offset_y, std::index_sequence<Edge...>) {
        (look_at<First, Edge>(own, other, offset_x, offset_y, std::make_index_sequence<N - 1>()), ...);
    }

    template <int First, int Edge, std::size_t... Vertex>
    TUMBLE_LANE_FUNCTION void look_at(const CoreOfPairs<N>& own, const CoreOfPairs<N>& other, const PairLanes<N>& offset_x,
                                      const PairLanes<N>& offset_y, std::index_sequence<Vertex...>) {
        constexpr int kNext = Edge + 1 < N ? Edge + 1 : 0, kAt = First + Edge;
        const PairLanes<N> edge_x = own.local_x[kNext] - own.local_x[Edge], edge_y = own.local_y[kNext] - own.local_y[Edge];
        const PairLanes<N> x = outward_x_of(own.c, own.s, edge_x, edge_y), y = outward_y_of(own.c, own.s, edge_x, edge_y);
        LowestLanes<N> lowest = begin_lowest(x * other.x[0] + y * other.y[0]);
        (take_lower(lowest, x * other.x[Vertex + 1] + y * other.y[Vertex + 1], Vertex + 1), ...);
        const PairLanes<N> length = square_root(x * x + y * y);
        const PairLanes<N> separation =
            separation_along(x, y, length, lowest.value, own.x[Edge], own.y[Edge], offset_x, offset_y);
        outward_x_[kAt] = x;
        outward_y_[kAt] = y;
        length_[kAt] = length;
        nearest_[kAt] = lowest.index;
        take_larger(leading_, separation, kAt);
    }

    const CoreOfPairs<N>* cores_[2];
    PairLanes<N> outward_x_[2 * N], outward_y_[2 * N], length_[2 * N];
    IndexLanes<N> nearest_[2 * N];
    LargestLanes<N> leading_ = begin_largest<N>();
};

}  // namespace tumble
