// Distances by b2Distance: the same vertices and poses, in float and in world coordinates.
#pragma once

#include <optional>

#include "reference/query/pair_query.hpp"

namespace tumble::reference {

struct B2Distance {
    double distance = 0.0;  // m, at least 0; 0 means overlap
    DVec2 point_a;          // witness points, world coordinates; both the middle if radii overlap
    DVec2 point_b;
    int iterations = 0;
};

// Passes any number of core vertices unchanged (no skin, no welding), with an empty cache. Nothing for input that would
// abort the process or does not fit float: no vertices, or a number that is not finite as a float. Box2D counts its
// calls in plain globals: one thread at a time.
std::optional<B2Distance> b2_distance(const PairQuery& query, bool use_radii);

}  // namespace tumble::reference
