#include "narrow/leading_features.hpp"

namespace tumble {

namespace {

// True if the vertex is higher in the direction than its neighbours, but for one that ends the same edge of the simplex.
// For a convex core that makes it the support. Strictly higher: equal neighbours may hide a higher vertex behind them.
bool is_support(const Core& core, int vertex, int partner, DVec2 direction) {
    if (core.count == 1) return true;
    const int next = core.next(vertex), previous = core.previous(vertex);
    return (next == partner || dot(direction, core.edge(vertex, next)) < 0.0) &&
           (previous == partner || dot(direction, core.edge(vertex, previous)) < 0.0);
}

}  // namespace

LedDistance distance_of_simplex(const CorePair& pair, const SimplexCache& cache) {
    LedDistance led;
    if (cache.count == 0 || cache.count == 3) return led;
    Simplex simplex = simplex_of_cache(pair, cache);
    const Closest closest = VoronoiRegions::reduce(pair, simplex);
    if (closest.contains_origin) return led;
    const double inverse_length = 1.0 / length(closest.direction);
    const VertexPair first = simplex.vertices[0].pair(), last = simplex.vertices[simplex.count - 1].pair();
    led.core.distance = closest.toward * inverse_length;
    led.core.normal = inverse_length * closest.direction;
    led.core.pairs[0] = first;
    led.core.pairs[1] = last;
    led.core.pair_count = simplex.count;
    led.exists = true;
    const bool is_rigid = first.a == last.a || first.b == last.b;
    led.is_proved = is_rigid && is_support(pair.a, first.a, last.a, closest.direction) &&
                    is_support(pair.b, first.b, last.b, -closest.direction);
    return led;
}

}  // namespace tumble
