// The choice of the edge that a manifold is clipped against.
#pragma once

#include "narrow/distance/core_distance.hpp"

namespace tumble {

struct ReferenceEdge {
    Side side = Side::none;  // none: two corners touch
    int edge = 0;            // by its first vertex
    int nearest = -1;        // the other core's vertex that is nearest to its line; -1 if it is not known
    DVec2 normal;            // unit, out of the owner; set if `nearest` is known
};

// The part of a core distance that a manifold needs.
struct ContactFeature {
    double distance;
    DVec2 normal;
    VertexPair pairs[2];
    int pair_count;
};

// The edge of the closest feature or of the deepest face, or the cached edge if its separation is less than theirs by
// at most `tolerance`.
ReferenceEdge choose_reference_edge(const CorePair& pair, const ContactFeature& core, const SimplexCache& cache,
                                    double tolerance);

}  // namespace tumble
