// The faces of many pairs of small cores, one pair in each lane: the formulas of face_lanes.hpp with lanes and loops
// exchanged.
#pragma once

#include <limits>
#include <utility>

#include "debug/check.hpp"
#include "narrow/faces/face_lanes.hpp"
#include "narrow/faces/feature_formulas.hpp"
#include "simd/gather_columns.hpp"

namespace tumble {

// As many pairs at once as a register has lanes. With more, half the numbers would be kept in memory.
inline constexpr int kPairs = DoubleLanes<8>::kWidth;
using PairLanes = DoubleLanes<kPairs>;
using PairMask = MaskLanes<kPairs>;

// One core of each pair, of at most N vertices.
template <int N>
struct CoreOfPairs {
    PairLanes c, s;
    PairLanes reach;  // at least |q| R
    PairLanes local_x[N], local_y[N];
    PairLanes x[N], y[N];  // turned, relative to the body's position

    CoreOfPairs(const Shape* const (&shapes)[kPairs], const Pose* const (&poses)[kPairs]) {
        const float *rows_x[kPairs], *rows_y[kPairs];
        for (int lane = 0; lane < kPairs; ++lane) {
            TUMBLE_CHECK(shapes[lane]->vertex_count() >= 1);
            TUMBLE_CHECK(shapes[lane]->vertex_count() <= N);
            rows_x[lane] = shapes[lane]->x().data();
            rows_y[lane] = shapes[lane]->y().data();
        }
        c = gather_lanes<kPairs>([&](int lane) { return static_cast<double>(poses[lane]->rotation.c); });
        s = gather_lanes<kPairs>([&](int lane) { return static_cast<double>(poses[lane]->rotation.s); });
        reach = turned_radius(c, s, gather_lanes<kPairs>([&](int lane) { return shapes[lane]->core_radius(); }));
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

// The CorePair of each lane.
template <int N>
struct CorePairs {
    CoreOfPairs<N> a;
    CoreOfPairs<N> b;
    PairLanes offset_x, offset_y;
    PairLanes scale;

    CorePairs(const Shape* const (&shapes_a)[kPairs], const Pose* const (&poses_a)[kPairs],
              const Shape* const (&shapes_b)[kPairs], const Pose* const (&poses_b)[kPairs])
        : a(shapes_a, poses_a), b(shapes_b, poses_b) {
        offset_x =
            gather_lanes<kPairs>([&](int lane) { return poses_b[lane]->position.x - poses_a[lane]->position.x; });
        offset_y =
            gather_lanes<kPairs>([&](int lane) { return poses_b[lane]->position.y - poses_a[lane]->position.y; });
        scale = (a.reach + b.reach) + square_root(offset_x * offset_x + offset_y * offset_y);
    }
};

// The face of largest separation of each pair, the first of equals: A's edges count from 0 on, B's from N on.
template <int N>
struct LeadingFaceOfPairs {
    FaceNumbers<PairLanes> face;  // its separation is minus infinity if no edge of the pair has a length
    PairLanes edge;
    PairLanes nearest;  // the other core's vertex
    PairMask is_tied;   // another face has the same separation
    PairMask is_b;

    PairMask exists() const { return PairLanes(-std::numeric_limits<double>::infinity()) < face.separation; }

    TUMBLE_LANE_FUNCTION explicit LeadingFaceOfPairs(const CorePairs<N>& pairs) {
        const PairLanes none(0.0);
        face = {none, none, none, PairLanes(-std::numeric_limits<double>::infinity()), none, none, none,
                none, none, none};
        edge = nearest = none;
        is_tied = none < none;
        scan<0>(pairs.a, pairs.b, pairs.offset_x, pairs.offset_y, std::make_index_sequence<N>());
        scan<N>(pairs.b, pairs.a, -pairs.offset_x, -pairs.offset_y, std::make_index_sequence<N>());
        is_b = PairLanes(N - 0.5) < edge;
        TUMBLE_CHECK(smallest(edge) >= 0.0);
        TUMBLE_CHECK(largest(edge) < 2.0 * N);
        TUMBLE_CHECK(smallest(nearest) >= 0.0);
        TUMBLE_CHECK(largest(nearest) < N);
        find_other(pairs.a, pairs.b, std::make_index_sequence<N>());
    }

private:
    // Unrolled, so that the largest separation so far and the lowest height stay in registers.
    template <int First, std::size_t... Edge>
    TUMBLE_LANE_FUNCTION void scan(const CoreOfPairs<N>& own, const CoreOfPairs<N>& other, const PairLanes& offset_x,
                                   const PairLanes& offset_y, std::index_sequence<Edge...>) {
        (scan_edge<First, Edge>(own, other, offset_x, offset_y, std::make_index_sequence<N - 1>()), ...);
    }

    template <int First, int Edge, std::size_t... Vertex>
    TUMBLE_LANE_FUNCTION void scan_edge(const CoreOfPairs<N>& own, const CoreOfPairs<N>& other,
                                        const PairLanes& offset_x, const PairLanes& offset_y,
                                        std::index_sequence<Vertex...>) {
        constexpr int kNext = Edge + 1 < N ? Edge + 1 : 0;
        const PairLanes edge_x = own.local_x[kNext] - own.local_x[Edge],
                        edge_y = own.local_y[kNext] - own.local_y[Edge];
        const PairLanes x = outward_x_of(own.c, own.s, edge_x, edge_y), y = outward_y_of(own.c, own.s, edge_x, edge_y);
        PairLanes lowest = x * other.x[0] + y * other.y[0];
        ((lowest = smaller(lowest, x * other.x[Vertex + 1] + y * other.y[Vertex + 1])), ...);
        const PairLanes length_sq = x * x + y * y, length = square_root(length_sq);
        const PairLanes separation =
            separation_along(x, y, length_sq, length, lowest, own.x[Edge], own.y[Edge], offset_x, offset_y);
        const PairMask is_larger = face.separation < separation;
        is_tied = (face.separation == separation) | (is_tied & ~is_larger);
        replace(face.separation, is_larger, separation);
        replace(face.outward_x, is_larger, x);
        replace(face.outward_y, is_larger, y);
        replace(face.length, is_larger, length);
        replace(face.first_x, is_larger, own.x[Edge]);
        replace(face.first_y, is_larger, own.y[Edge]);
        replace(face.second_x, is_larger, own.x[kNext]);
        replace(face.second_y, is_larger, own.y[kNext]);
        replace(edge, is_larger, PairLanes(First + Edge));
    }

    // The lowest vertex of the other core, the first of equals. It is searched for the leading face only: the scan
    // needs no more than the lowest height.
    template <std::size_t... Vertex>
    TUMBLE_LANE_FUNCTION void find_other(const CoreOfPairs<N>& a, const CoreOfPairs<N>& b,
                                         std::index_sequence<Vertex...>) {
        PairLanes lowest(std::numeric_limits<double>::infinity());
        const auto take = [&](int vertex) __attribute__((always_inline)) {
            const PairLanes x = select(is_b, a.x[vertex], b.x[vertex]), y = select(is_b, a.y[vertex], b.y[vertex]);
            const PairLanes height = face.outward_x * x + face.outward_y * y;
            const PairMask is_lower = height < lowest;
            lowest = smaller(lowest, height);
            replace(face.other_x, is_lower, x);
            replace(face.other_y, is_lower, y);
            replace(nearest, is_lower, PairLanes(vertex));
        };
        (take(Vertex), ...);
    }
};

}  // namespace tumble
