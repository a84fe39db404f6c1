// The choice of the edge that a manifold is clipped against.
#pragma once

#include "narrow/distance/small_features.hpp"

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
ReferenceEdge search_reference_edge(const CorePair& pair, const ContactFeature& core, const SimplexCache& cache,
                                    double tolerance);

// True if the closest feature is an edge of a polygon and a vertex, and the cache holds no other edge: most contacts.
[[gnu::always_inline]] inline bool find_edge_of_face(const CorePair& pair, const ContactFeature& core,
                                                     const SimplexCache& cache, ReferenceEdge& edge) {
    const VertexPair first = core.pairs[0], second = core.pairs[1];
    const unsigned is_b = first.a == second.a;
    const Core* const cores[2] = {&pair.a, &pair.b};
    const Side side = is_b ? Side::b : Side::a;
    edge.side = side;
    edge.edge = own_vertex(is_b, first);
    edge.nearest = own_vertex(1 - is_b, first);
    edge.normal.x = kSign[is_b] * core.normal.x;
    edge.normal.y = kSign[is_b] * core.normal.y;
    const bool is_face = core.pair_count == 2 && own_vertex(1 - is_b, second) == edge.nearest &&
                         cores[is_b]->count > 2 && cores[is_b]->next(edge.edge) == own_vertex(is_b, second);
    const bool is_kept =
        cache.reference_side == Side::none || (cache.reference_side == side && cache.reference_edge == edge.edge);
    return is_face && is_kept;
}

[[gnu::always_inline]] inline ReferenceEdge choose_reference_edge(const CorePair& pair, const ContactFeature& core,
                                                                  const SimplexCache& cache, double tolerance) {
    ReferenceEdge edge;
    return find_edge_of_face(pair, core, cache, edge) ? edge : search_reference_edge(pair, core, cache, tolerance);
}

}  // namespace tumble
