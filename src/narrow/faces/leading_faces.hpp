// The faces of largest separation of small cores, by their indices and numbers.
//
// Which core owns a face and which edge it is cannot be predicted: both are chosen by index, since a branch would be
// mispredicted half the time.
#pragma once

#include <bit>
#include <limits>

#include "debug/check.hpp"
#include "narrow/faces/face_lanes.hpp"
#include "narrow/faces/feature_formulas.hpp"

namespace tumble {

// The sign of a vector from the owner to the other core relative to one from A to B, by the owner: 0 for A, 1 for B.
inline constexpr double kSign[2] = {1.0, -1.0};

// A face of A - B by its indices and numbers.
struct OwnedFace {
    unsigned is_b;  // the owner
    int from;       // the ends of its edge
    int to;
    int nearest;  // the other core's vertex
    FaceNumbers<double> numbers;
};

// One face by its edge's first vertex, with the same bits as faces_of(). The offset is from the owner's position to the
// other core's; `is_b` names the owner.
template <int N>
TUMBLE_LANE_FUNCTION OwnedFace find_face(const Core& owner, const Core& other_core, double offset_x, double offset_y,
                                         unsigned is_b, int from) {
    TUMBLE_CHECK(from >= 0);
    TUMBLE_CHECK(from < owner.count);
    const TurnedCore<N> other = turn<N>(other_core);
    const int to = owner.next(from);
    const DVec2 edge = owner.edge(from, to), first = owner.point(from), second = owner.point(to);
    const double x = edge.y, y = -edge.x;
    const DoubleLanes<N> of_other = heights(other, x, y);
    const DoubleLanes<N> all_lowest = spread_smallest(of_other);
    const double lowest = first_lane(all_lowest);
    const int nearest = std::countr_zero(bits_of(of_other == all_lowest));
    TUMBLE_CHECK(nearest < other_core.count);
    const double own_height = x * first.x + y * first.y;
    const double gap = (lowest - own_height) + (offset_x * x + offset_y * y);
    const double length = std::sqrt(x * x + y * y);
    return {is_b,
            from,
            to,
            nearest,
            {x, y, length, gap / length, first.x, first.y, second.x, second.y, other.x[nearest], other.y[nearest]}};
}

// The same, of one core of a pair.
template <int N>
TUMBLE_LANE_FUNCTION OwnedFace find_face(const CorePair& pair, unsigned is_b, int from) {
    const Core* const cores[2] = {&pair.a, &pair.b};
    return find_face<N>(*cores[is_b], *cores[1 - is_b], kSign[is_b] * pair.offset.x, kSign[is_b] * pair.offset.y, is_b,
                        from);
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
      of_b(faces_of(cores.b, turned_cores[1], turned_cores[0], -cores.offset.x, -cores.offset.y)) {
    const DoubleLanes<N> all_largest = spread_largest(larger(of_a.separation, of_b.separation));
    separation = first_lane(all_largest);
    bits = bits_of(of_a.separation == all_largest) | bits_of(of_b.separation == all_largest) << N;
    if (!(separation > -std::numeric_limits<double>::infinity())) bits = 0;
}

template <int N>
OwnedFace LeadingFaces<N>::first() const {
    const unsigned bit = static_cast<unsigned>(std::countr_zero(bits)), is_b = bit >= N;
    TUMBLE_CHECK(bits != 0u);
    TUMBLE_CHECK(bit < 2u * N);
    const int from = static_cast<int>(bit % N);
    const Core* const cores[2] = {&pair.a, &pair.b};
    const FaceLanes<N>* const faces[2] = {&of_a, &of_b};
    const FaceLanes<N>& face = *faces[is_b];
    const TurnedCore<N>& own = turned[is_b];
    const TurnedCore<N>& other = turned[1 - is_b];
    const int to = cores[is_b]->next(from), nearest = static_cast<int>(face.nearest[from]);
    TUMBLE_CHECK(from < cores[is_b]->count);
    TUMBLE_CHECK(nearest < cores[1 - is_b]->count);
    TUMBLE_CHECK(face.length[from] > 0.0);
    const double x = face.outward_x[from], y = face.outward_y[from];
    return {is_b,
            from,
            to,
            nearest,
            {x, y, face.length[from], separation, own.x[from], own.y[from], own.x[to], own.y[to], other.x[nearest],
             other.y[nearest]}};
}

}  // namespace tumble
