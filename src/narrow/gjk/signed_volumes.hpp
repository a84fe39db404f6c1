// The distance subalgorithm by signed volumes [MPB17], in the plane: lengths and areas in place of Johnson's products.
//
// The weight of a vertex has the sign of the volume of the simplex with the vertex replaced by the origin. If that
// differs from the sign of the whole, the origin lies beyond the face opposite to the vertex, which then has the
// nearest point.
#pragma once

#include "debug/check.hpp"
#include "narrow/cores/error_bound.hpp"
#include "narrow/gjk/simplex.hpp"

namespace tumble {

struct SignedVolumes {
    [[gnu::always_inline]] static Closest reduce(const CorePair& pair, Simplex& simplex) {
        TUMBLE_CHECK(simplex.count >= 1);
        TUMBLE_CHECK(simplex.count <= 3);
        if (simplex.count == 1) return closest_on_vertex(simplex.vertices[0]);
        const MinkowskiVertex(&v)[3] = simplex.vertices;
        return simplex.count == 2 ? reduce_segment(simplex, 0, 1, edge_between(pair, v[0], v[1]))
                                  : reduce_triangle(pair, simplex);
    }

private:
    [[gnu::always_inline]] static bool have_same_sign(double a, double b) {
        return (a > 0.0 && b > 0.0) || (a < 0.0 && b < 0.0);
    }

    // S1D: the foot of the origin if it lies between the ends along the axis on which the edge is longest, else the end
    // beyond which it lies.
    [[gnu::always_inline]] static Closest reduce_segment(Simplex& simplex, int from, int to, DVec2 edge) {
        TUMBLE_CHECK(from < simplex.count);
        TUMBLE_CHECK(to < simplex.count);
        const DVec2 start = simplex.vertices[from].w;
        const double along = -dot(start, edge) / length_sq(edge);
        const bool by_x = std::abs(edge.x) >= std::abs(edge.y);
        const double whole = by_x ? edge.x : edge.y;
        const double to_foot = along * whole, to_end = whole - to_foot;
        if (!have_same_sign(to_foot, whole)) return keep_vertex(simplex, from);
        if (!have_same_sign(to_end, whole)) return keep_vertex(simplex, to);
        return keep_edge(simplex, from, to, edge);
    }

    // S2D. An area below its own rounding has no sign: by the paper's test alone an origin beyond a sharp tip would
    // count as inside.
    [[gnu::always_inline]] static Closest reduce_triangle(const CorePair& pair, Simplex& simplex) {
        const MinkowskiVertex(&v)[3] = simplex.vertices;
        const DVec2 edges[3] = {edge_between(pair, v[1], v[2]), edge_between(pair, v[2], v[0]),
                                edge_between(pair, v[0], v[1])};  // opposite to each vertex
        const double whole = cross(edges[2], edges[0]);
        Simplex best;
        Closest closest = closest_at_origin();
        for (int vertex = 0; vertex < 3; ++vertex) {
            const int from = vertex == 2 ? 0 : vertex + 1, to = vertex == 0 ? 2 : vertex - 1;
            const double area = cross(v[from].w, edges[vertex]);
            const double rounding =
                8.0 * kUnitRoundoff * pair.scale * (std::abs(edges[vertex].x) + std::abs(edges[vertex].y));
            if (std::abs(area) > rounding && have_same_sign(area, whole)) continue;
            Simplex behind = simplex;
            const Closest there = reduce_segment(behind, from, to, edges[vertex]);
            if (best.count > 0 && !(there.distance_sq < closest.distance_sq)) continue;
            best = behind;
            closest = there;
        }
        TUMBLE_CHECK(best.count <= 2);
        if (best.count > 0) simplex = best;
        return closest;
    }
};

}  // namespace tumble
