// The error of the witness points of an answer.
#pragma once

#include "reference/box2d/b2_distance.hpp"
#include "reference/query/pair_query.hpp"
#include "tumble/distance.hpp"

namespace tumble::reference {

// The absolute distance of a world point from the surface of the shape, in double (m). O(n).
double surface_distance(const Shape& shape, const Pose& world_from_shape, DVec2 point);

// The largest of the two surface distances and of the deviation of the points' offset from `distance` (along the
// normal, if the engine returns one). NaN if a point is not finite.
double witness_error(const PairQuery& query, const DistanceResult& result);
double witness_error(const PairQuery& query, const B2Distance& result);

}  // namespace tumble::reference
