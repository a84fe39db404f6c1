// The distance of A and B by one feature of A - B, a face or a vertex: the arithmetic that one pair and many pairs in
// lanes share. The decisions that follow from it are in measure_cores.hpp and, with masks, in measure_pairs.hpp.
#pragma once

#include "narrow/cores/error_bound.hpp"
#include "simd/double_lanes.hpp"

namespace tumble {

// A face of A - B relative to the position of the core that owns its edge, in world axes.
template <typename Number>
struct FaceNumbers {
    Number outward_x;
    Number outward_y;
    Number length;  // of `outward`
    Number separation;
    Number first_x, first_y, second_x, second_y;  // the ends of its edge
    Number other_x, other_y;                      // the other core's vertex, relative to the other core's position
};

template <typename Number>
struct FaceMeasure {
    Number normal_x, normal_y;  // outward
    Number own_x, own_y;        // the point of the face's line nearest to the other core's vertex
    Number before, behind;      // the foot is beyond the first end if before >= 0, beyond the second if behind <= 0
};

// The offset is from the owner's position to the other core's.
template <typename Number>
TUMBLE_LANE_FUNCTION FaceMeasure<Number> measure(const FaceNumbers<Number>& face, const Number& offset_x,
                                                 const Number& offset_y) {
    const Number normal_x = face.outward_x / face.length, normal_y = face.outward_y / face.length;
    // The edge is outward turned by a quarter: (-y, x).
    const Number before_x = (face.first_x - face.other_x) - offset_x,
                 before_y = (face.first_y - face.other_y) - offset_y;
    const Number behind_x = (face.second_x - face.other_x) - offset_x,
                 behind_y = (face.second_y - face.other_y) - offset_y;
    return {normal_x,
            normal_y,
            (face.other_x + offset_x) - face.separation * normal_x,
            (face.other_y + offset_y) - face.separation * normal_y,
            before_y * face.outward_x - before_x * face.outward_y,
            behind_y * face.outward_x - behind_x * face.outward_y};
}

// From a vertex of A - B, a - b, to the origin.
template <typename Number>
struct VertexMeasure {
    Number x, y;
    Number distance_sq;
    Number distance;
    Number height;  // of A - B in that direction
    Number proved;  // a lower bound: no point of A - B is nearer
    Number normal_x, normal_y;
};

// `height_a` and `lowest_b` are the cores' own in the direction (x, y), which to_origin() gives.
template <typename Number>
TUMBLE_LANE_FUNCTION Number to_origin(const Number& a, const Number& b, const Number& offset) {
    return -((a - b) - offset);
}

template <typename Number>
TUMBLE_LANE_FUNCTION VertexMeasure<Number> measure_vertex(const Number& x, const Number& y, const Number& height_a,
                                                          const Number& lowest_b, const Number& offset_x,
                                                          const Number& offset_y) {
    const Number height = (height_a - lowest_b) - (x * offset_x + y * offset_y);
    const Number distance_sq = x * x + y * y, distance = square_root(distance_sq), proved = -height / distance;
    return {x, y, distance_sq, distance, height, smaller(proved, distance), x / distance, y / distance};
}

}  // namespace tumble
