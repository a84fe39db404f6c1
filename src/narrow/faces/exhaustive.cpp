#include "narrow/faces/exhaustive.hpp"

#include <limits>

#include "debug/check.hpp"
#include "narrow/faces/faces.hpp"

namespace tumble {

namespace {

class Nearest {
public:
    explicit Nearest(const CorePair& pair) : pair_(pair) {}

    void consider(VertexPair from, VertexPair to) {
        Simplex simplex;
        simplex.vertices[0] = minkowski_vertex(pair_, from);
        simplex.vertices[1] = minkowski_vertex(pair_, to);
        simplex.count = 2;
        const Closest closest = reduce_edge(pair_, simplex);
        TUMBLE_CHECK(!(closest.distance_sq < 0.0));
        if (!(closest.distance_sq < distance_sq_)) return;
        TUMBLE_CHECK(simplex.count >= 1);
        TUMBLE_CHECK(simplex.count <= 2);
        distance_sq_ = closest.distance_sq;
        simplex_ = simplex;
    }

    void consider(FoundFace found) {
        move_below_origin(pair_, found.face);
        consider(found.face.pairs[0], found.face.pairs[1]);
    }

    const Simplex& simplex() const { return simplex_; }

private:
    const CorePair& pair_;
    Simplex simplex_;
    double distance_sq_ = std::numeric_limits<double>::infinity();
};

void consider_all_pairs(const CorePair& pair, Nearest& nearest) {
    for (int a = 0; a < pair.a.count; ++a) {
        for (int b = 0; b < pair.b.count; ++b) {
            nearest.consider(make_pair_of(a, b), make_pair_of(pair.a.next(a), b));
            nearest.consider(make_pair_of(a, b), make_pair_of(a, pair.b.next(b)));
        }
    }
}

void consider_all_faces(const CorePair& pair, Nearest& nearest) {
    for (int edge = 0; edge < pair.a.count; ++edge) nearest.consider(face_of_a(pair, edge));
    for (int edge = 0; edge < pair.b.count; ++edge) nearest.consider(face_of_b(pair, edge));
}

}  // namespace

Simplex nearest_simplex(const CorePair& pair) {
    Nearest nearest(pair);
    const bool has_many_faces = pair.a.is_convex && pair.b.is_convex && !has_few_faces(pair);
    if (has_many_faces)
        consider_all_faces(pair, nearest);
    else
        consider_all_pairs(pair, nearest);
    return nearest.simplex();
}

}  // namespace tumble
