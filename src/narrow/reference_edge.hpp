// Which edge a manifold is clipped against, if any.
#pragma once

#include "narrow/core_distance.hpp"

namespace tumble {

struct ReferenceEdge {
    Side side = Side::none;  // none: two corners meet
    int edge = 0;            // by its first vertex
};

// The edge that holds the closest feature, the deepest face, or the cached one if its separation is within `tolerance`
// of theirs.
ReferenceEdge choose_reference_edge(const CorePair& pair, const CoreDistance& core, const SimplexCache& cache,
                                    double tolerance);

}  // namespace tumble
