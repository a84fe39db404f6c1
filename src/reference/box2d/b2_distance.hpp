// b2Distance as the second engine: the same vertices and poses, in world coordinates and float.
#pragma once

#include <optional>

#include "reference/query/pair_query.hpp"

namespace tumble::reference {

struct B2Distance {
    double distance = 0.0;  // m, at least 0; 0 is how b2Distance says overlap
    DVec2 point_a;          // witness points, world coordinates; both the middle if radii overlap
    DVec2 point_b;
    int iterations = 0;
};

// Feeds the core vertices as they are (no skin, no welding), any number of them, starting cold. Nothing for what the
// library would stop the process at, or cannot hold: no vertices, or a number that is not finite as a float.
// Box2D counts its calls in plain globals: never call this in two threads at once.
std::optional<B2Distance> b2_distance(const PairQuery& query, bool use_radii);

}  // namespace tumble::reference
