// Queries between bodies of many shapes: the nearest pair of parts, found without querying most pairs.
//
// A compound is a set of shapes at one pose. The signed distance of two bounding boxes is a lower bound of that of
// their shapes: pairs are visited in the order of this bound, until it exceeds the best answer.
#pragma once

#include <cstdint>
#include <span>

#include "tumble/cast.hpp"
#include "tumble/distance.hpp"
#include "tumble/math.hpp"
#include "tumble/shape.hpp"

namespace tumble {

struct CompoundDistance {
    // Of the pair of parts with the least computed distance; of equal ones the lowest part_a, then part_b. For
    // overlapping compounds it is the deepest overlap of two parts, which may be less than the depth of the compounds.
    DistanceResult nearest;
    std::int32_t part_a = -1;
    std::int32_t part_b = -1;
    double lower = 0.0;  // the least exact signed distance of all pairs lies in [lower, upper]
    double upper = 0.0;
    DistanceStatus status = DistanceStatus::invalid;  // of [lower, upper]
    std::int32_t queries = 0;                         // pairs for which distance() was called
};

// The signed distance of two compounds. The same bits as the least of distance() over all pairs. `invalid`, with NaN
// and no parts, if a compound has no shapes or one of its shapes or the pose is invalid. Takes O(n log n + n m) for n
// and m parts, but with a few operations for most pairs; allocates only for more than 250 parts of both together.
CompoundDistance compound_distance(std::span<const Shape> a, const Pose& world_from_a, std::span<const Shape> b,
                                   const Pose& world_from_b);

struct CompoundOverlap {
    DistanceStatus status = DistanceStatus::invalid;
    std::int32_t part_a = -1;  // a pair that overlaps, or touches if none overlaps; -1 if separated or invalid
    std::int32_t part_b = -1;
    std::int32_t queries = 0;
};

// Whether any two parts overlap: `overlapping` with the first such pair in the order of visit, which is the same for
// equal input; `touching` if none is proved to, but the sign of one could not be decided.
CompoundOverlap compound_overlap(std::span<const Shape> a, const Pose& world_from_a, std::span<const Shape> b,
                                 const Pose& world_from_b);

struct CompoundCast {
    // Of the pair of parts that touches first; of equal fractions the lowest part_a, then part_b. `overlapping` with
    // the first pair in the order of visit if any overlaps at the start.
    CastResult first;
    std::int32_t part_a = -1;  // -1 if nothing is hit
    std::int32_t part_b = -1;
    std::int32_t queries = 0;  // pairs that were cast
};

// The casts of cast.hpp against bodies of many shapes: the same bits as the first of all pairs. A pair whose boxes
// touch later than the first hit is not cast. `invalid` and allocation as for compound_distance().
CompoundCast compound_cast_ray(std::span<const Shape> parts, const Pose& world_from_parts, DVec2 origin,
                               DVec2 translation);
CompoundCast compound_cast_shape(std::span<const Shape> a, const Pose& world_from_a, std::span<const Shape> b,
                                 const Pose& world_from_b, DVec2 translation, double target = 0.0);
CompoundCast compound_time_of_impact(std::span<const Shape> a, const Sweep& sweep_a, std::span<const Shape> b,
                                     const Sweep& sweep_b, double target = 0.0);

}  // namespace tumble
