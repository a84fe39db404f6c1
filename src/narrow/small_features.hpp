// The signed distance of small cores by one feature of A - B: measured, and proved or refused. Every way to an answer
// ends here, so that it has the same bits whichever way it was found.
//
// Which core owns a face, and which edge it is, is as good as random: both are chosen by index, since a branch would be
// mispredicted half the time.
#pragma once

#include <bit>

#include "narrow/core_distance.hpp"
#include "narrow/face_lanes.hpp"
#include "narrow/feature_formulas.hpp"

namespace tumble {

// By a vertex of A - B, a of A and b of B: for the direction from it to the origin no other one is higher, within
// rounding.
template <int N>
TUMBLE_LANE_FUNCTION bool measure_by_vertex(const CorePair& pair, const TurnedPair<N>& turned, VertexPair at,
                                            CoreDistance& result) {
    const double a_x = turned[0].x[at.a], a_y = turned[0].y[at.a], b_x = turned[1].x[at.b], b_y = turned[1].y[at.b];
    const double x = to_origin(a_x, b_x, pair.offset.x), y = to_origin(a_y, b_y, pair.offset.y);
    const VertexMeasure<double> measured = measure_vertex(
        x, y, largest(heights(turned[0], x, y)), smallest(heights(turned[1], x, y)), pair.offset.x, pair.offset.y);
    result.distance = measured.distance;
    result.lower = measured.proved - error_bound(pair);
    result.upper = measured.distance + error_bound(pair);
    result.direction.x = x;
    result.direction.y = y;
    result.normal.x = measured.normal_x;
    result.normal.y = measured.normal_y;
    result.on_a.x = a_x;
    result.on_a.y = a_y;
    result.on_b.x = b_x;
    result.on_b.y = b_y;
    result.pairs[0].a = result.pairs[1].a = at.a;
    result.pairs[0].b = result.pairs[1].b = at.b;
    result.pair_count = 1;
    result.overlap = false;
    return measured.distance_sq + measured.height <= progress_bound(pair) * measured.distance && result.lower > 0.0;
}

// What B sees where A sees x, by who owns a face: 0 for A, 1 for B.
inline constexpr double kSign[2] = {1.0, -1.0};

// A face of A - B by its indices and numbers.
struct OwnedFace {
    unsigned is_b;  // the owner
    int from;       // the ends of its edge
    int to;
    int nearest;  // the other core's vertex
    SeenFace<double> seen;
};

// Where the foot of the origin lies on a face: between its ends, or beyond one of them.
enum class Foot { inside, beyond_first, beyond_second };

// The face's separation is a lower bound, and the distance if the foot is inside.
[[gnu::always_inline]] inline Foot measure_by_face(const CorePair& pair, const OwnedFace& face, CoreDistance& result) {
    const double sign = kSign[face.is_b];
    const SeenFace<double>& seen = face.seen;
    const FaceMeasure<double> measured = measure(seen, sign * pair.offset.x, sign * pair.offset.y);
    result.distance = seen.separation;
    result.lower = seen.separation - error_bound(pair);
    result.upper = seen.separation + error_bound(pair);
    result.direction.x = sign * seen.outward_x;
    result.direction.y = sign * seen.outward_y;
    result.normal.x = sign * measured.normal_x;
    result.normal.y = sign * measured.normal_y;
    double on_x[2], on_y[2];
    on_x[face.is_b] = measured.own_x;
    on_y[face.is_b] = measured.own_y;
    on_x[1 - face.is_b] = seen.other_x;
    on_y[1 - face.is_b] = seen.other_y;
    result.on_a.x = on_x[0];
    result.on_a.y = on_y[0];
    result.on_b.x = on_x[1];
    result.on_b.y = on_y[1];
    result.pairs[0] = pair_of_owner(face.is_b, face.from, face.nearest);
    result.pairs[1] = pair_of_owner(face.is_b, face.to, face.nearest);
    result.pair_count = 2;
    result.overlap = result.upper < 0.0;
    if (measured.before >= 0.0) return Foot::beyond_first;
    return measured.behind <= 0.0 ? Foot::beyond_second : Foot::inside;
}

// One face by its owner and its edge's first vertex; the numbers are those that faces_of() finds for it.
template <int N>
TUMBLE_LANE_FUNCTION OwnedFace find_face(const CorePair& pair, unsigned is_b, int from) {
    const Core* const cores[2] = {&pair.a, &pair.b};
    const Core& owner = *cores[is_b];
    const TurnedCore<N> other = turn<N>(*cores[1 - is_b]);
    const double sign = kSign[is_b], offset_x = sign * pair.offset.x, offset_y = sign * pair.offset.y;
    const int to = owner.next(from);
    const DVec2 edge = owner.edge(from, to), first = owner.point(from), second = owner.point(to);
    const double x = edge.y, y = -edge.x;
    const DoubleLanes<N> of_other = heights(other, x, y);
    const double lowest = smallest(of_other);
    const int nearest = std::countr_zero(bits_of(of_other == DoubleLanes<N>(lowest)));
    const double own_height = x * first.x + y * first.y;
    const double gap = (lowest - own_height) + (offset_x * x + offset_y * y);
    const double length = std::sqrt(x * x + y * y);
    return {is_b,
            from,
            to,
            nearest,
            {x, y, length, gap / length, first.x, first.y, second.x, second.y, other.x[nearest], other.y[nearest]}};
}

// The faces of largest separation.
template <int N>
struct LeadingFaces {
    const CorePair& pair;
    const TurnedPair<N>& turned;
    FaceLanes<N> of_a;
    FaceLanes<N> of_b;
    double separation;
    unsigned bits;  // the edges of A from bit 0 on, those of B from bit N on; none if no edge has a length

    TUMBLE_LANE_FUNCTION LeadingFaces(const CorePair& cores, const TurnedPair<N>& turned_cores);
    TUMBLE_LANE_FUNCTION OwnedFace first() const;
};

template <int N>
LeadingFaces<N>::LeadingFaces(const CorePair& cores, const TurnedPair<N>& turned_cores)
    : pair(cores),
      turned(turned_cores),
      of_a(faces_of(cores.a, turned_cores[0], turned_cores[1], cores.offset.x, cores.offset.y)),
      of_b(faces_of(cores.b, turned_cores[1], turned_cores[0], -cores.offset.x, -cores.offset.y)),
      separation(largest(larger(of_a.separation, of_b.separation))),
      bits(bits_of(of_a.separation == DoubleLanes<N>(separation)) |
           bits_of(of_b.separation == DoubleLanes<N>(separation)) << N) {
    if (!(separation > -std::numeric_limits<double>::infinity())) bits = 0;
}

template <int N>
OwnedFace LeadingFaces<N>::first() const {
    const unsigned bit = static_cast<unsigned>(std::countr_zero(bits)), is_b = bit >= N;
    const int from = static_cast<int>(bit % N);
    const Core* const cores[2] = {&pair.a, &pair.b};
    const FaceLanes<N>* const faces[2] = {&of_a, &of_b};
    const FaceLanes<N>& face = *faces[is_b];
    const TurnedCore<N>& own = turned[is_b];
    const TurnedCore<N>& other = turned[1 - is_b];
    const int to = cores[is_b]->next(from), nearest = static_cast<int>(face.nearest[from]);
    const double x = face.outward_x[from], y = face.outward_y[from];
    return {is_b,
            from,
            to,
            nearest,
            {x, y, face.length[from], separation, own.x[from], own.y[from], own.x[to], own.y[to], other.x[nearest],
             other.y[nearest]}};
}

}  // namespace tumble
