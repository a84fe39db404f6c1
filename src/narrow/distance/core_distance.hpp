// The signed distance of two cores, with its bounds: by GJK if they are separated, by the deepest face if they are not.
#pragma once

#include <algorithm>

#include "debug/check.hpp"
#include "narrow/faces/exhaustive.hpp"
#include "narrow/faces/faces.hpp"
#include "narrow/gjk/gjk.hpp"
#include "narrow/gjk/start.hpp"
#include "narrow/gjk/voronoi.hpp"

namespace tumble {

struct CoreDistance {
    double distance = 0.0;  // signed, of the cores
    double lower = 0.0;     // the exact one lies in [lower, upper]
    double upper = 0.0;
    DVec2 direction;  // from A to B; proves `lower`
    DVec2 normal;     // the same, of unit length; (1, 0) if the cores coincide in a point
    DVec2 on_a;       // witness points of the cores, relative to A's and to B's position, in world axes
    DVec2 on_b;
    VertexPair pairs[2];  // the closest vertex or edge of A - B, or the face of largest separation
    int pair_count = 0;
    bool overlap = false;  // proved
    int iterations = 0;
    bool reached_cap = false;
};

// The result of the loop replaced by that of the nearest simplex of all: for a loop that stopped early, or whose
// triangle contains the origin by rounding alone.
GjkResult exhaustive_search(const CorePair& pair, GjkResult stopped);

// True if the loop's own bounds are apart by more than rounding explains.
[[gnu::always_inline]] inline bool stopped_early(const CorePair& pair, const GjkResult& gjk) {
    if (gjk.closest.contains_origin) return false;
    TUMBLE_CHECK(!(gjk.closest.toward < 0.0));
    const double gap = gjk.closest.toward + gjk.height, bound = 2.0 * error_bound(pair);
    return gap > 0.0 && gap * gap > bound * bound * length_sq(gjk.closest.direction);
}

// The core distance that follows from GJK's last simplex.
CoreDistance conclude(const CorePair& pair, GjkResult gjk);

inline constexpr auto kUnobserved = [](const Simplex&, const Closest&, const MinkowskiSupport&) {};

// By GJK alone. A cache, if given, supplies the first simplex and receives the last.
template <typename Reducer, typename Observer>
[[gnu::always_inline]] inline CoreDistance measure_by_gjk(const CorePair& pair, SimplexCache* cache,
                                                          Observer&& observe) {
    Simplex start;
    if (cache) start = simplex_of_cache(pair, *cache);
    const bool is_cold = start.count == 0;
    GjkResult gjk = run_gjk<Reducer>(pair, is_cold ? first_simplex(pair) : start, observe);
    if (gjk.reached_cap || stopped_early(pair, gjk)) gjk = exhaustive_search(pair, gjk);
    gjk.iterations += is_cold;
    if (cache) store(gjk.simplex, *cache);
    return conclude(pair, gjk);
}

}  // namespace tumble
