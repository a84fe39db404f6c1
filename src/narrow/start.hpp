// Where GJK starts: at the previous simplex if there is one, else at the support towards the other shape.
#pragma once

#include "narrow/simplex.hpp"

namespace tumble {

inline bool is_in_range(const CorePair& pair, VertexPair at) { return at.a < pair.a.count && at.b < pair.b.count; }

// Empty for a cache that is empty or does not fit the shapes. A stale one costs iterations only.
inline Simplex simplex_of_cache(const CorePair& pair, const SimplexCache& cache) {
    Simplex simplex;
    if (cache.count > 3) return simplex;
    for (int i = 0; i < cache.count; ++i) {
        const VertexPair at = cache.pairs[static_cast<std::size_t>(i)];
        if (!is_in_range(pair, at)) return {};
        simplex.vertices[simplex.count++] = minkowski_vertex(pair, at);
    }
    return simplex;
}

inline void store(const Simplex& simplex, SimplexCache& cache) {
    for (int i = 0; i < simplex.count; ++i) cache.pairs[static_cast<std::size_t>(i)] = simplex.vertices[i].pair;
    cache.count = static_cast<std::uint8_t>(simplex.count);
}

// The support in the direction from A's position to B's: nearer than an arbitrary vertex, and as symmetric.
inline Simplex first_simplex(const CorePair& pair) {
    Simplex simplex;
    simplex.vertices[0] = support(pair, pair.offset).vertex;
    simplex.count = 1;
    return simplex;
}

}  // namespace tumble
