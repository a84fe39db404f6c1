// The signed distance of small cores by one feature of A - B, with the proof that no other feature is nearer. All paths
// to an answer end with these formulas, so the answer has the same bits on each.
#pragma once

#include "debug/check.hpp"
#include "narrow/distance/core_distance.hpp"
#include "narrow/faces/leading_faces.hpp"

namespace tumble {

// By a vertex of A - B, a of A and b of B. True if it is proved to be the nearest: no other vertex is higher in the
// direction from it to the origin, within rounding.
template <int N>
TUMBLE_LANE_FUNCTION bool measure_by_vertex(const CorePair& pair, const TurnedPair<N>& turned, VertexPair at,
                                            CoreDistance& result) {
    TUMBLE_CHECK(at.a < pair.a.count);
    TUMBLE_CHECK(at.b < pair.b.count);
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

// Where the foot of the origin lies on a face: between its ends, or beyond one of them.
enum class Foot { inside, beyond_first, beyond_second };

// A measured face as a core distance, but for the witness points. The face's separation is a lower bound, and the
// distance if the foot is inside.
[[gnu::always_inline]] inline Foot write_face(CoreDistance& result, const OwnedFace& face,
                                              const FaceMeasure<double>& measured, double error) {
    const double sign = kSign[face.is_b];
    const FaceNumbers<double>& numbers = face.numbers;
    result.distance = numbers.separation;
    result.lower = numbers.separation - error;
    result.upper = numbers.separation + error;
    result.direction.x = sign * numbers.outward_x;
    result.direction.y = sign * numbers.outward_y;
    result.normal.x = sign * measured.normal_x;
    result.normal.y = sign * measured.normal_y;
    result.pairs[0] = pair_of_owner(face.is_b, face.from, face.nearest);
    result.pairs[1] = pair_of_owner(face.is_b, face.to, face.nearest);
    result.pair_count = 2;
    result.overlap = result.upper < 0.0;
    TUMBLE_CHECK(!(result.upper < result.lower));
    if (measured.before >= 0.0) return Foot::beyond_first;
    return measured.behind <= 0.0 ? Foot::beyond_second : Foot::inside;
}

[[gnu::always_inline]] inline Foot measure_by_face(const CorePair& pair, const OwnedFace& face, CoreDistance& result) {
    const double sign = kSign[face.is_b];
    const FaceMeasure<double> measured = measure(face.numbers, sign * pair.offset.x, sign * pair.offset.y);
    double on_x[2], on_y[2];
    on_x[face.is_b] = measured.own_x;
    on_y[face.is_b] = measured.own_y;
    on_x[1 - face.is_b] = face.numbers.other_x;
    on_y[1 - face.is_b] = face.numbers.other_y;
    result.on_a.x = on_x[0];
    result.on_a.y = on_y[0];
    result.on_b.x = on_x[1];
    result.on_b.y = on_y[1];
    return write_face(result, face, measured, error_bound(pair));
}

}  // namespace tumble
