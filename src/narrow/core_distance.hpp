// The signed distance of two cores, with its bounds: GJK where they are separated, the deepest face where they are not.
#pragma once

#include <algorithm>

#include "narrow/exhaustive.hpp"
#include "narrow/faces.hpp"
#include "narrow/gjk.hpp"
#include "narrow/start.hpp"
#include "narrow/voronoi.hpp"

namespace tumble {

struct CoreDistance {
    double distance = 0.0;  // signed, of the cores
    double lower = 0.0;     // the exact one lies in [lower, upper]
    double upper = 0.0;
    DVec2 direction;      // from A to B; proves `lower`
    DVec2 normal;         // the same, of unit length; (1, 0) if the cores coincide in a point
    VertexPair pairs[2];  // the closest vertex or edge of A - B, or the face of largest separation
    int pair_count = 0;
    bool overlap = false;  // proved
    int iterations = 0;
    bool reached_cap = false;
};

// By division, so that a direction along an axis gives a normal of exactly 1.
[[gnu::always_inline]] inline DVec2 quotient(DVec2 v, double divisor) {
    return {v.x / divisor, v.y / divisor};
}

// GJK's answer, for cores that do not share a point.
[[gnu::always_inline]] inline CoreDistance separated_cores(const CorePair& pair, const GjkResult& gjk) {
    const Closest& closest = gjk.closest;
    const double length_of_direction = length(closest.direction);
    CoreDistance result;
    result.distance = gjk.simplex.count == 1 ? length_of_direction : closest.toward / length_of_direction;
    result.lower = std::min(result.distance, -gjk.height / length_of_direction) - error_bound(pair);
    result.upper = result.distance + error_bound(pair);
    result.direction = closest.direction;
    result.normal = quotient(closest.direction, length_of_direction);
    result.pairs[0] = gjk.simplex.vertices[0].pair();
    result.pairs[1] = gjk.simplex.vertices[1].pair();
    result.pair_count = gjk.simplex.count;
    result.iterations = gjk.iterations;
    result.reached_cap = gjk.reached_cap;
    return result;
}

// The answer for all cores that GJK does not prove to be separated: they overlap, or touch within rounding.
CoreDistance unseparated_cores(const CorePair& pair, GjkResult gjk);

// GJK from the simplex that all pairs of a vertex and an edge give, for a loop that stopped early.
GjkResult exhaustive_search(const CorePair& pair, GjkResult stopped);

// True if the loop's own bounds are apart by more than rounding explains.
[[gnu::always_inline]] inline bool stopped_early(const CorePair& pair, const GjkResult& gjk) {
    if (gjk.closest.contains_origin) return false;
    const double gap = gjk.closest.toward + gjk.height, bound = 2.0 * error_bound(pair);
    return gap > 0.0 && gap * gap > bound * bound * length_sq(gjk.closest.direction);
}

[[gnu::always_inline]] inline CoreDistance conclude(const CorePair& pair, const GjkResult& gjk) {
    if (gjk.closest.contains_origin) return unseparated_cores(pair, gjk);
    const CoreDistance result = separated_cores(pair, gjk);
    return result.lower > 0.0 ? result : unseparated_cores(pair, gjk);
}

// A cache, if given, supplies the first simplex and receives the last.
template <typename SubAlgorithm, typename Observer>
[[gnu::always_inline]] inline CoreDistance measure_cores(const CorePair& pair, SimplexCache* cache,
                                                         Observer&& observe) {
    Simplex start;
    if (cache) start = simplex_of_cache(pair, *cache);
    const bool is_cold = start.count == 0;
    GjkResult gjk = run_gjk<SubAlgorithm>(pair, is_cold ? first_simplex(pair) : start, observe);
    if (gjk.reached_cap || stopped_early(pair, gjk)) gjk = exhaustive_search(pair, gjk);
    gjk.iterations += is_cold;
    if (cache) store(gjk.simplex, *cache);
    return conclude(pair, gjk);
}

}  // namespace tumble
