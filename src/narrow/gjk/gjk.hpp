// The GJK loop [GJK88; seeds: the main algorithm]: for convex cores, in the plane, with any distance subalgorithm.
#pragma once

#include <limits>

#include "narrow/cores/error_bound.hpp"
#include "narrow/gjk/simplex.hpp"

namespace tumble {

// What the loop ends with: the simplex nearest to the origin, and the support in its direction that says so.
struct GjkResult {
    Simplex simplex;
    Closest closest;
    double height = 0.0;  // the largest direction . w; meaningless if the simplex contains the origin
    int iterations = 0;   // support pairs computed
    bool reached_cap = false;
};

// Never reached in practice for n <= 8 (7 observed); each iteration strictly shortens v, so this bounds time only.
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
    if (holds(best.simplex, support.key)) return true;
    const DVec2 d = best.closest.direction;
    const double progress = dot(d, support.w - best.simplex.vertices[0].w);
    const double bound = progress_bound(pair);
    return progress <= 0.0 || progress * progress <= bound * bound * length_sq(d);
}

// By constant indices, as everywhere in the loop: the simplex then lives in registers, which is also why the hot
// functions are inlined by force.
[[gnu::always_inline]] inline void add(Simplex& simplex, const MinkowskiVertex& vertex) {
    if (simplex.count == 1)
        simplex.vertices[1] = vertex;
    else
        simplex.vertices[2] = vertex;
    ++simplex.count;
}

// Where rounding hides that a simplex is nearer than the best one, its direction may still prove more: that of an edge
// whose foot is a hair's breadth from the vertex that the best one is. By value: an address would keep the loop's
// simplex out of registers, 20 of 115 ns.
[[gnu::noinline]] inline GjkResult with_better_proof(const CorePair& pair, GjkResult best, Simplex simplex,
                                                     Closest closest) {
    if (closest.contains_origin) return best;
    const double height = support(pair, closest.direction, simplex.vertices[0].pair()).height;
    ++best.iterations;
    if (height * length(best.closest.direction) < best.height * length(closest.direction)) {
        best.simplex = simplex;
        best.closest = closest;
        best.height = height;
    }
    return best;
}

// `Reducer::reduce(pair, simplex)` reduces the simplex to the smallest subset that holds the point nearest to the
// origin, and says where that is. `observe(simplex, closest, support)` sees each iteration before the support is added.
template <typename Reducer, typename Observer>
[[gnu::always_inline]] inline GjkResult run_gjk(const CorePair& pair, Simplex simplex, Observer&& observe) {
    const int cap = iteration_cap(pair);
    GjkResult best;
    best.closest.distance_sq = std::numeric_limits<double>::infinity();
    for (;;) {
        const Closest closest = Reducer::reduce(pair, simplex);
        if (!(closest.distance_sq < best.closest.distance_sq)) return with_better_proof(pair, best, simplex, closest);
        best.simplex = simplex;
        best.closest = closest;
        if (closest.contains_origin) return best;
        const MinkowskiSupport found = support(pair, closest.direction, simplex.vertices[0].pair());
        best.height = found.height;
        ++best.iterations;
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
