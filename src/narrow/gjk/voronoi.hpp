// The distance subalgorithm by Voronoi regions [Eri04, 5.1.5]: it finds the region of the simplex that contains the
// origin.
//
// Vertex regions are tested before edge regions: their dot products are well conditioned also for slivers, so that
// an origin beyond a sharp tip is never taken as inside.
#pragma once

#include "debug/check.hpp"
#include "narrow/gjk/simplex.hpp"

namespace tumble {

struct VoronoiRegions {
    // Reduces the simplex to the smallest subset that contains the point nearest to the origin, and returns that point.
    [[gnu::always_inline]] static Closest reduce(const CorePair& pair, Simplex& simplex) {
        TUMBLE_CHECK(simplex.count >= 1);
        TUMBLE_CHECK(simplex.count <= 3);
        if (simplex.count == 1) return closest_on_vertex(simplex.vertices[0]);
        return simplex.count == 2 ? reduce_edge(pair, simplex) : reduce_triangle(pair, simplex);
    }

private:
    [[gnu::always_inline]] static Closest reduce_triangle(const CorePair& pair, Simplex& simplex) {
        const MinkowskiVertex(&v)[3] = simplex.vertices;
        const DVec2 e01 = edge_between(pair, v[0], v[1]), e12 = edge_between(pair, v[1], v[2]),
                    e20 = edge_between(pair, v[2], v[0]);
        // How far each edge runs past the origin, from its first end and from its second.
        const double from01 = -dot(v[0].w, e01), to01 = dot(v[1].w, e01);
        const double from12 = -dot(v[1].w, e12), to12 = dot(v[2].w, e12);
        const double from20 = -dot(v[2].w, e20), to20 = dot(v[0].w, e20);
        if (from01 <= 0.0 && to20 <= 0.0) return keep_vertex(simplex, 0);
        if (from12 <= 0.0 && to01 <= 0.0) return keep_vertex(simplex, 1);
        if (from20 <= 0.0 && to12 <= 0.0) return keep_vertex(simplex, 2);
        // The side of each edge on which the origin lies: positive inside, for either winding of the triangle.
        const double turn = cross(e01, e12) < 0.0 ? -1.0 : 1.0;
        const double side01 = turn * cross(v[0].w, e01), side12 = turn * cross(v[1].w, e12),
                     side20 = turn * cross(v[2].w, e20);
        if (side01 <= 0.0 && from01 > 0.0 && to01 > 0.0) return keep_edge(simplex, 0, 1, e01);
        if (side12 <= 0.0 && from12 > 0.0 && to12 > 0.0) return keep_edge(simplex, 1, 2, e12);
        if (side20 <= 0.0 && from20 > 0.0 && to20 > 0.0) return keep_edge(simplex, 2, 0, e20);
        return closest_at_origin();
    }
};

}  // namespace tumble
