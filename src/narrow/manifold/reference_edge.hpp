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

// Sets the edge that the ends of the closest feature span, from the first one, with the other core's vertex of the
// first end as the nearest. False if the ends are not an edge of a polygon in its order.
[[gnu::always_inline]] inline bool set_edge_of_ends(const CorePair& pair, const ContactFeature& core,
                                                    ReferenceEdge& edge) {
    const VertexPair first = core.pairs[0], second = core.pairs[1];
    const unsigned is_b = first.a == second.a;
    const Core* const cores[2] = {&pair.a, &pair.b};
    edge.side = is_b ? Side::b : Side::a;
    edge.edge = own_vertex(is_b, first);
    edge.nearest = own_vertex(1 - is_b, first);
    edge.normal.x = kSign[is_b] * core.normal.x;
    edge.normal.y = kSign[is_b] * core.normal.y;
    return cores[is_b]->count > 2 && cores[is_b]->next(edge.edge) == own_vertex(is_b, second);
}

// True if one vertex is at both ends of the closest feature: an edge of one core and a vertex of the other.
[[gnu::always_inline]] inline bool has_common_vertex(const ContactFeature& core) {
    const unsigned other_is_b = core.pairs[0].a != core.pairs[1].a;
    return own_vertex(other_is_b, core.pairs[0]) == own_vertex(other_is_b, core.pairs[1]);
}

// True if the closest feature is an edge of a polygon and a vertex, and the cache holds no other edge: most contacts.
[[gnu::always_inline]] inline bool find_edge_of_face(const CorePair& pair, const ContactFeature& core,
                                                     const SimplexCache& cache, ReferenceEdge& edge) {
    const bool is_edge = set_edge_of_ends(pair, core, edge);
    const bool is_kept =
        cache.reference_side == Side::none || (cache.reference_side == edge.side && cache.reference_edge == edge.edge);
    return core.pair_count == 2 && is_edge && has_common_vertex(core) && is_kept;
}

[[gnu::always_inline]] inline ReferenceEdge choose_reference_edge(const CorePair& pair, const ContactFeature& core,
                                                                  const SimplexCache& cache, double tolerance) {
    ReferenceEdge edge;
    return find_edge_of_face(pair, core, cache, edge) ? edge : search_reference_edge(pair, core, cache, tolerance);
}

}  // namespace tumble
