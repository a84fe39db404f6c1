// The core distance by the fastest method for the sizes of the cores (the table in src/narrow/README.md).
//
// `finish` turns the CoreDistance into the caller's answer and is inlined: a struct that passes through memory costs
// more than the arithmetic, because its halves are stored one by one and read together.
#pragma once

#include "debug/check.hpp"
#include "narrow/distance/small_features.hpp"

namespace tumble {

// For at most eight vertices, if the leading face does not decide: parallel faces, or contact within rounding.
CoreDistance search_small_cores(const CorePair& pair, SimplexCache* cache);

// GJK for any number of vertices, and for outlines that are not convex.
CoreDistance measure_any_cores(const CorePair& pair, SimplexCache* cache);

[[gnu::always_inline]] inline bool measure_points(const CorePair& pair, CoreDistance& result) {
    const DVec2 a = pair.a.point(0), b = pair.b.point(0);
    const double x = -((a.x - b.x) - pair.offset.x), y = -((a.y - b.y) - pair.offset.y);
    const double distance = std::sqrt(x * x + y * y);
    result.distance = distance;
    result.lower = distance - error_bound(pair);
    result.upper = distance + error_bound(pair);
    result.direction.x = x;
    result.direction.y = y;
    result.normal.x = x / distance;
    result.normal.y = y / distance;
    result.on_a.x = a.x;
    result.on_a.y = a.y;
    result.on_b.x = b.x;
    result.on_b.y = b.y;
    result.pair_count = 1;
    result.iterations = 1;
    return distance > 0.0;
}

// The feature that the leading face decides for: the face itself if the foot of the origin is inside it, else the
// vertex at its end. No vertex if faces are equally separated, as its choice would depend on the order of the shapes.
enum class Decision { face, vertex, none };

[[gnu::always_inline]] inline Decision decide(Foot foot, bool leads_alone, const CoreDistance& by_face) {
    const bool is_apart = by_face.lower > 0.0;
    if (foot == Foot::inside) return is_apart || by_face.overlap ? Decision::face : Decision::none;
    return is_apart && leads_alone ? Decision::vertex : Decision::none;
}

[[gnu::always_inline]] inline VertexPair end_of(const OwnedFace& face, Foot foot) {
    return pair_of_owner(face.is_b, foot == Foot::beyond_first ? face.from : face.to, face.nearest);
}

// Whether two pairs are the ends of a face of A - B: of an edge of `owner` and a vertex of the other core. Any pairs
// are safe.
[[gnu::always_inline]] inline bool are_ends(const Core& owner, unsigned is_b, VertexPair first, VertexPair second) {
    const int from = own_vertex(is_b, first), to = own_vertex(is_b, second);
    const bool is_edge = (from < owner.count) & (owner.next(from) == to) & (from != to);
    return is_edge & (own_vertex(1 - is_b, first) == own_vertex(1 - is_b, second));
}

// The distance by the face between two pairs, if they are the ends of one and the nearest point lies inside it.
template <int N>
TUMBLE_LANE_FUNCTION bool measure_by_ends(const CorePair& pair, VertexPair first, VertexPair second,
                                          CoreDistance& result) {
    const unsigned is_b = first.a == second.a;
    const Core* const cores[2] = {&pair.a, &pair.b};
    if (!are_ends(*cores[is_b], is_b, first, second)) return false;
    return measure_by_face(pair, find_face<N>(pair, is_b, own_vertex(is_b, first)), result) == Foot::inside &&
           result.lower > 0.0;
}

[[gnu::always_inline]] inline void store(const CoreDistance& core, SimplexCache& cache) {
    TUMBLE_CHECK(core.pair_count >= 1);
    TUMBLE_CHECK(core.pair_count <= 2);
    cache.pairs[0].a = core.pairs[0].a;
    cache.pairs[0].b = core.pairs[0].b;
    cache.pairs[1].a = core.pairs[1].a;
    cache.pairs[1].b = core.pairs[1].b;
    cache.count = static_cast<std::uint8_t>(core.lower > 0.0 ? core.pair_count : 0);
}

// The first of the leading faces. If it is the one that the last manifold was clipped against, its numbers do not wait
// for the search: a manifold of boxes takes 77 ns instead of 86.
template <int N>
TUMBLE_LANE_FUNCTION OwnedFace first_face(const LeadingFaces<N>& leading, const SimplexCache* cache) {
    if (cache && cache->reference_side != Side::none && cache->reference_edge < N) {
        const unsigned is_b = cache->reference_side == Side::b;
        if (leading.bits == 1u << (cache->reference_edge + N * is_b))
            return find_face<N>(leading.pair, is_b, cache->reference_edge);
    }
    return leading.first();
}

// False where the leading face does not decide.
template <int N>
TUMBLE_LANE_FUNCTION bool measure_features(const CorePair& pair, SimplexCache* cache, CoreDistance& result) {
    result.iterations = 1;
    if (cache && cache->count == 2 && measure_by_ends<N>(pair, cache->pairs[0], cache->pairs[1], result)) return true;
    const TurnedPair<N> turned = {turn<N>(pair.a), turn<N>(pair.b)};
    if (cache && cache->count == 1 && is_in_range(pair, cache->pairs[0]) &&
        measure_by_vertex<N>(pair, turned, cache->pairs[0], result))
        return true;
    result.iterations = 2;
    const LeadingFaces<N> leading(pair, turned);
    if (leading.bits == 0) return false;
    const OwnedFace face = first_face(leading, cache);
    const Foot foot = measure_by_face(pair, face, result);
    const Decision decision = decide(foot, std::has_single_bit(leading.bits), result);
    if (decision == Decision::vertex) return measure_by_vertex<N>(pair, turned, end_of(face, foot), result);
    return decision == Decision::face;
}

template <int N, typename Finish>
[[gnu::noinline]] auto measure_small(const CorePair& pair, SimplexCache* cache, const Finish& finish) {
    CoreDistance result;
    if (!measure_features<N>(pair, cache, result)) return finish(search_small_cores(pair, cache));
    if (cache) store(result, *cache);
    return finish(result);
}

// A cache, if given, supplies the first feature or simplex and receives the last.
template <typename Finish>
[[gnu::always_inline]] inline auto measure_cores(const CorePair& pair, SimplexCache* cache, const Finish& finish) {
    TUMBLE_CHECK(pair.a.count >= 1);
    TUMBLE_CHECK(pair.b.count >= 1);
    TUMBLE_CHECK(pair.scale >= 0.0);
    const int largest = std::max(pair.a.count, pair.b.count);
    if (largest == 1) {
        CoreDistance result;
        if (measure_points(pair, result)) return finish(result);
        return finish(search_small_cores(pair, cache));
    }
    if (!has_few_faces(pair)) return finish(measure_any_cores(pair, cache));
    return largest <= 4 ? measure_small<4>(pair, cache, finish) : measure_small<8>(pair, cache, finish);
}

}  // namespace tumble
