// The GJK loop [GJK88] for convex cores in the plane, with any distance subalgorithm.
#pragma once

#include <limits>

#include "debug/check.hpp"
#include "narrow/cores/error_bound.hpp"
#include "narrow/gjk/simplex.hpp"

namespace tumble {

// The result of the loop: the simplex nearest to the origin, and the support height that proves it.
struct GjkResult {
    Simplex simplex;
    Closest closest;
    double height = 0.0;  // the largest direction . w; meaningless if the simplex contains the origin
    int iterations = 0;   // support pairs computed
    bool reached_cap = false;
};

// Each iteration strictly shortens v, so the loop ends without a cap; the cap bounds the time. Seven iterations are the
// most observed for n <= 8.
[[gnu::always_inline]] inline int iteration_cap(const CorePair& pair) {
    int cap = 32;
    for (int doubled = 8; doubled < pair.a.count + pair.b.count; doubled *= 2) cap += 4;
    return cap;
}

// For a reduced simplex that does not contain the origin: one vertex or two.
[[gnu::always_inline]] inline bool holds(const Simplex& simplex, std::uint32_t key) {
    return simplex.vertices[0].key == key || (simplex.count == 2 && simplex.vertices[1].key == key);
}

// True if the support is one of the simplex's vertices or no nearer to the origin than they are.
[[gnu::always_inline]] inline bool has_converged(const CorePair& pair, const GjkResult& best,
                                                 const MinkowskiVertex& support) {
    TUMBLE_CHECK(best.simplex.count <= 2);
    if (holds(best.simplex, support.key)) return true;
    const DVec2 d = best.closest.direction;
    const double progress = dot(d, support.w - best.simplex.vertices[0].w);
    const double bound = progress_bound(pair);
    return progress <= 0.0 || progress * progress <= bound * bound * length_sq(d);
}

// By constant indices, as everywhere in the loop, so that the simplex stays in registers. The hot functions are forced
// inline for the same reason.
[[gnu::always_inline]] inline void add(Simplex& simplex, const MinkowskiVertex& vertex) {
    TUMBLE_CHECK(simplex.count < 3);
    if (simplex.count == 1)
        simplex.vertices[1] = vertex;
    else
        simplex.vertices[2] = vertex;
    ++simplex.count;
}

// If rounding hides that a simplex is nearer than the best one, its direction may still prove a higher lower bound: the
// nearest points of both lie within rounding of each other, but the directions may differ by much more. While the bound
// rises, support vertices that stand out along the new direction are added; the cap bounds the time. By value: an
// address would keep the loop's simplex out of registers, 20 of 115 ns. `observe` as in run_gjk().
template <typename Reducer, typename Observer>
[[gnu::noinline]] GjkResult with_better_proof(const CorePair& pair, GjkResult best, Simplex simplex, Closest closest,
                                              Observer&& observe) {
    const int cap = iteration_cap(pair);
    for (int round = 0; round < cap && !closest.contains_origin; ++round) {
        TUMBLE_CHECK(!best.closest.contains_origin);
        const MinkowskiSupport found = support(pair, closest.direction, simplex.vertices[0].pair());
        ++best.iterations;
        observe(simplex, closest, found);
        if (!(found.height * length(best.closest.direction) < best.height * length(closest.direction))) break;
        best.simplex = simplex;
        best.closest = closest;
        best.height = found.height;
        if (has_converged(pair, best, found.vertex)) break;
        add(simplex, found.vertex);
        closest = Reducer::reduce(pair, simplex);
    }
    return best;
}

// `Reducer::reduce(pair, simplex)` reduces the simplex to the smallest subset that contains the point nearest to the
// origin and returns that point. `observe(simplex, closest, support)` is called in each iteration before the support is
// added.
template <typename Reducer, typename Observer>
[[gnu::always_inline]] inline GjkResult run_gjk(const CorePair& pair, Simplex simplex, Observer&& observe) {
    TUMBLE_CHECK(simplex.count >= 1);
    TUMBLE_CHECK(simplex.count <= 3);
    const int cap = iteration_cap(pair);
    GjkResult best;
    best.closest.distance_sq = std::numeric_limits<double>::infinity();
    for (;;) {
        const Closest closest = Reducer::reduce(pair, simplex);
        if (!(closest.distance_sq < best.closest.distance_sq))
            return with_better_proof<Reducer>(pair, best, simplex, closest, observe);
        best.simplex = simplex;
        best.closest = closest;
        if (closest.contains_origin) return best;
        const MinkowskiSupport found = support(pair, closest.direction, simplex.vertices[0].pair());
        best.height = found.height;
        ++best.iterations;
        TUMBLE_CHECK(best.iterations <= cap);
        observe(simplex, closest, found);
        if (has_converged(pair, best, found.vertex)) return best;
        if (best.iterations >= cap) {
            best.reached_cap = true;
            return best;
        }
        add(simplex, found.vertex);
    }
}

}  // namespace tumble
