// The first simplex of GJK: the previous one if there is one, else the support towards the other shape.
#pragma once

#include "debug/check.hpp"
#include "narrow/gjk/simplex.hpp"

namespace tumble {

[[gnu::always_inline]] inline bool is_in_range(const CorePair& pair, VertexPair at) {
    return at.a < pair.a.count && at.b < pair.b.count;
}

// Empty for a cache that is empty or has indices out of range. A stale cache costs iterations only.
[[gnu::always_inline]] inline Simplex simplex_of_cache(const CorePair& pair, const SimplexCache& cache) {
    Simplex simplex;
    const int count = cache.count;
    if (count == 0 || count > 3 || !is_in_range(pair, cache.pairs[0])) return simplex;
    if (count > 1 && !is_in_range(pair, cache.pairs[1])) return simplex;
    if (count > 2 && !is_in_range(pair, cache.pairs[2])) return simplex;
    simplex.vertices[0] = minkowski_vertex(pair, cache.pairs[0]);
    if (count > 1) simplex.vertices[1] = minkowski_vertex(pair, cache.pairs[1]);
    if (count > 2) simplex.vertices[2] = minkowski_vertex(pair, cache.pairs[2]);
    simplex.count = count;
    return simplex;
}

[[gnu::always_inline]] inline void store(const Simplex& simplex, SimplexCache& cache) {
    TUMBLE_CHECK(simplex.count <= 3);
    cache.count = static_cast<std::uint8_t>(simplex.count);
    cache.pairs[0] = simplex.vertices[0].pair();
    if (simplex.count > 1) cache.pairs[1] = simplex.vertices[1].pair();
    if (simplex.count > 2) cache.pairs[2] = simplex.vertices[2].pair();
}

// The support in the direction from A's position to B's: nearer than an arbitrary vertex, and as symmetric.
[[gnu::always_inline]] inline Simplex first_simplex(const CorePair& pair) {
    Simplex simplex;
    simplex.vertices[0] = support(pair, pair.offset).vertex;
    simplex.count = 1;
    return simplex;
}

}  // namespace tumble
