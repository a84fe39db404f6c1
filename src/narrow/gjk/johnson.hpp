// Johnson's distance subalgorithm [GJK88, section 5], with the backup procedure.
//
// For a subset X of the vertices and i in X the cofactor delta_i(X) is the weight of w_i in the point of X's affine
// hull nearest to the origin, times the sum of all weights, which is positive:
//   delta_i({i}) = 1,  delta_j(X + j) = sum over i in X of delta_i(X) (w_i . w_k - w_i . w_j),  k any one of X.
// X contains the nearest point if all its own cofactors are positive and that of no vertex outside is. A cofactor of
// three vertices is a product of four lengths, and for slivers rounding changes its sign first. If no
// subset satisfies all conditions then, the backup takes the nearest of those whose own cofactors are positive
// [vdB04, 4.3].
#pragma once

#include "debug/check.hpp"
#include "narrow/gjk/simplex.hpp"

namespace tumble {

struct Johnson {
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
        // Cofactors of two vertices, by the edge between them, divided by the square of the scale: the products below
        // would overflow otherwise.
        TUMBLE_CHECK(pair.scale > 0.0);
        const double unit = 1.0 / (pair.scale * pair.scale);
        const double delta0_of_01 = unit * dot(v[1].w, e01), delta1_of_01 = -unit * dot(v[0].w, e01);
        const double delta1_of_12 = unit * dot(v[2].w, e12), delta2_of_12 = -unit * dot(v[1].w, e12);
        const double delta2_of_20 = unit * dot(v[0].w, e20), delta0_of_20 = -unit * dot(v[2].w, e20);
        if (delta1_of_01 <= 0.0 && delta2_of_20 <= 0.0) return keep_vertex(simplex, 0);
        if (delta2_of_12 <= 0.0 && delta0_of_01 <= 0.0) return keep_vertex(simplex, 1);
        if (delta0_of_20 <= 0.0 && delta1_of_12 <= 0.0) return keep_vertex(simplex, 2);

        const double delta0 = delta1_of_12 * delta0_of_01 + delta2_of_12 * (unit * dot(v[2].w, e01));
        const double delta1 = delta2_of_20 * delta1_of_12 + delta0_of_20 * (unit * dot(v[0].w, e12));
        const double delta2 = delta0_of_01 * delta2_of_20 + delta1_of_01 * (unit * dot(v[1].w, e20));
        const bool is_on_01 = delta0_of_01 > 0.0 && delta1_of_01 > 0.0,
                   is_on_12 = delta1_of_12 > 0.0 && delta2_of_12 > 0.0,
                   is_on_20 = delta2_of_20 > 0.0 && delta0_of_20 > 0.0;
        if (is_on_01 && delta2 <= 0.0) return keep_edge(simplex, 0, 1, e01);
        if (is_on_12 && delta0 <= 0.0) return keep_edge(simplex, 1, 2, e12);
        if (is_on_20 && delta1 <= 0.0) return keep_edge(simplex, 2, 0, e20);
        if (delta0 > 0.0 && delta1 > 0.0 && delta2 > 0.0) return closest_at_origin();

        Backup nearest(simplex);
        for (int vertex = 0; vertex < 3; ++vertex) nearest.consider_vertex(vertex);
        if (is_on_01) nearest.consider_edge(0, 1, e01);
        if (is_on_12) nearest.consider_edge(1, 2, e12);
        if (is_on_20) nearest.consider_edge(2, 0, e20);
        return nearest.take(simplex);
    }

    // The nearest of the subsets that are considered.
    class Backup {
    public:
        explicit Backup(const Simplex& simplex) : all_(simplex) {}

        void consider_vertex(int vertex) {
            Simplex kept = all_;
            keep(kept, keep_vertex(kept, vertex));
        }
        void consider_edge(int from, int to, DVec2 edge) {
            Simplex kept = all_;
            keep(kept, keep_edge(kept, from, to, edge));
        }
        Closest take(Simplex& simplex) const {
            TUMBLE_CHECK(best_.count >= 1);
            TUMBLE_CHECK(best_.count <= 2);
            simplex = best_;
            return closest_;
        }

    private:
        void keep(const Simplex& kept, const Closest& closest) {
            if (best_.count > 0 && !(closest.distance_sq < closest_.distance_sq)) return;
            best_ = kept;
            closest_ = closest;
        }

        Simplex all_;
        Simplex best_;
        Closest closest_;
    };
};

}  // namespace tumble
