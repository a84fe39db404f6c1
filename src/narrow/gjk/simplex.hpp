// The simplex of the GJK loop and its point nearest to the origin.
#pragma once

#include "debug/check.hpp"
#include "narrow/cores/support.hpp"

namespace tumble {

struct Simplex {
    MinkowskiVertex vertices[3];
    int count = 0;
};

// The point of a reduced simplex nearest to the origin: v = -(toward / |d|^2) d.
struct Closest {
    DVec2 direction;               // d, from the simplex to the origin: -w of a vertex, a perpendicular of an edge
    double toward = 0.0;           // -d . w of the simplex, not negative: |v| = toward / |d|
    double distance_sq = 0.0;      // |v|^2
    bool contains_origin = false;  // v = 0: a triangle around the origin, or the origin on an edge or a vertex
};

[[gnu::always_inline]] inline Closest closest_at_origin() { return {{}, 0.0, 0.0, true}; }

[[gnu::always_inline]] inline Closest closest_on_vertex(const MinkowskiVertex& vertex) {
    const double distance_sq = length_sq(vertex.w);
    return {-vertex.w, distance_sq, distance_sq, distance_sq == 0.0};
}

// For an origin between the ends. The height of the origin over the line is taken from the edge's middle, so that
// exchanging the ends negates it exactly.
[[gnu::always_inline]] inline Closest closest_on_edge(const MinkowskiVertex& from, const MinkowskiVertex& to,
                                                      DVec2 edge) {
    const double twice_height = cross(from.w + to.w, edge);
    const DVec2 direction = twice_height < 0.0 ? -perp(edge) : perp(edge);
    const double toward = 0.5 * std::abs(twice_height);
    return {direction, toward, toward / length_sq(edge) * toward, toward == 0.0};
}

// An edge between vertices of one polygon that is short relative to the scale. It is taken from the local coordinates,
// as the rounding of its ends would turn it. By indices: the address of a vertex would keep the loop's simplex out of
// registers.
DVec2 short_edge_between(const CorePair& pair, VertexPair from, VertexPair to);

[[gnu::always_inline]] inline DVec2 edge_between(const CorePair& pair, const MinkowskiVertex& from,
                                                 const MinkowskiVertex& to) {
    constexpr double kShortEdge = 0x1p-4;  // of the scale; the ends of a longer edge turn it by less than 2^7 ulp
    const DVec2 edge = to.w - from.w;
    if (length_sq(edge) >= kShortEdge * kShortEdge * pair.scale * pair.scale) return edge;
    return short_edge_between(pair, from.pair(), to.pair());
}

// The results of a distance subalgorithm: the simplex is reduced to the smallest subset that contains the nearest
// point.

[[gnu::always_inline]] inline Closest keep_vertex(Simplex& simplex, int vertex) {
    TUMBLE_CHECK(vertex < simplex.count);
    simplex.vertices[0] = simplex.vertices[vertex];
    simplex.count = 1;
    return closest_on_vertex(simplex.vertices[0]);
}

[[gnu::always_inline]] inline Closest keep_edge(Simplex& simplex, int from, int to, DVec2 edge) {
    TUMBLE_CHECK(from != to);
    TUMBLE_CHECK(from < simplex.count);
    TUMBLE_CHECK(to < simplex.count);
    const MinkowskiVertex kept_from = simplex.vertices[from], kept_to = simplex.vertices[to];
    simplex.vertices[0] = kept_from;
    simplex.vertices[1] = kept_to;
    simplex.count = 2;
    return closest_on_edge(kept_from, kept_to, edge);
}

// For two vertices the Voronoi regions and the signs of Johnson's cofactors are the same test.
[[gnu::always_inline]] inline Closest reduce_edge(const CorePair& pair, Simplex& simplex) {
    const DVec2 edge = edge_between(pair, simplex.vertices[0], simplex.vertices[1]);
    if (dot(simplex.vertices[0].w, edge) >= 0.0) return keep_vertex(simplex, 0);
    if (dot(simplex.vertices[1].w, edge) <= 0.0) return keep_vertex(simplex, 1);
    return keep_edge(simplex, 0, 1, edge);
}

}  // namespace tumble
