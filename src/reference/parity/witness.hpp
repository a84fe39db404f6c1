// How far the witness points of an answer are from what they claim to be.
#pragma once

#include "reference/box2d/b2_distance.hpp"
#include "reference/query/pair_query.hpp"
#include "tumble/distance.hpp"

namespace tumble::reference {

// The distance of a world point from the surface of the shape, from either side, in double (m). O(n).
double surface_distance(const Shape& shape, const Pose& world_from_shape, DVec2 point);

// The larger of the two surface distances, and how far the points are from being `distance` apart: along the normal
// where the engine gives one. NaN if a point is not finite.
double witness_error(const PairQuery& query, const DistanceResult& result);
double witness_error(const PairQuery& query, const B2Distance& result);

}  // namespace tumble::reference
