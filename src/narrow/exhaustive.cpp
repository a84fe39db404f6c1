#include "narrow/exhaustive.hpp"

#include <limits>

#include "narrow/voronoi.hpp"

namespace tumble {

namespace {

class Nearest {
public:
    explicit Nearest(const CorePair& pair) : pair_(pair) {}

    void consider(int from_a, int from_b, int to_a, int to_b) {
        Simplex simplex;
        simplex.vertices[0] = vertex(from_a, from_b);
        simplex.vertices[1] = vertex(to_a, to_b);
        simplex.count = 2;
        const Closest closest = VoronoiRegions::reduce(pair_, simplex);
        if (!(closest.distance_sq < distance_sq_)) return;
        distance_sq_ = closest.distance_sq;
        simplex_ = simplex;
    }

    const Simplex& simplex() const { return simplex_; }

private:
    MinkowskiVertex vertex(int a, int b) const {
        return minkowski_vertex(pair_, {static_cast<std::uint16_t>(a), static_cast<std::uint16_t>(b)});
    }

    const CorePair& pair_;
    Simplex simplex_;
    double distance_sq_ = std::numeric_limits<double>::infinity();
};

}  // namespace

Simplex nearest_simplex(const CorePair& pair) {
    Nearest nearest(pair);
    for (int a = 0; a < pair.a.count; ++a) {
        for (int b = 0; b < pair.b.count; ++b) {
            nearest.consider(a, b, pair.a.next(a), b);
            nearest.consider(a, b, a, pair.b.next(b));
        }
    }
    return nearest.simplex();
}

}  // namespace tumble
