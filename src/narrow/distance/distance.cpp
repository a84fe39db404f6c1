// distance(): validity, the distance of the cores, then the radii.
#include "tumble/distance.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "narrow/distance/distance_result.hpp"
#include "narrow/distance/measure_cores.hpp"

namespace tumble {

DistanceResult invalid_result() {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    DistanceResult result;
    result.distance = result.lower = result.upper = nan;
    result.point_a = result.point_b = result.normal = result.certificate.direction = {nan, nan};
    return result;
}

namespace {

// A function of its own, so that the pair of the query below stays in registers.
[[gnu::noinline]] DistanceResult distance_of_coincident(const Shape& a, const Pose& world_from_a, const Shape& b,
                                                        const Pose& world_from_b) {
    const CorePair pair = make_core_pair(a, world_from_a, b, world_from_b);
    return make_result(search_small_cores(pair, nullptr), a, b, world_from_a.position, world_from_b.position);
}

[[gnu::noinline]] DistanceResult distance_of_circles(const Shape& a, const Pose& world_from_a, const Shape& b,
                                                     const Pose& world_from_b, SimplexCache* cache) {
    const CorePair pair = make_core_pair(a, world_from_a, b, world_from_b);
    if (!is_valid(pair, a, b)) return invalid_result();
    CoreDistance result;
    if (!measure_points(pair, result)) return distance_of_coincident(a, world_from_a, b, world_from_b);
    if (cache) store(result, *cache);
    return make_result(result, a, b, world_from_a.position, world_from_b.position);
}

[[gnu::noinline]] DistanceResult distance_of_any(const Shape& a, const Pose& world_from_a, const Shape& b,
                                                 const Pose& world_from_b, SimplexCache* cache) {
    const CorePair pair = make_core_pair(a, world_from_a, b, world_from_b);
    if (!is_valid(pair, a, b)) return invalid_result();
    return measure_cores(
        pair, cache, [&](const CoreDistance& core) __attribute__((always_inline)) {
            return make_result(core, a, b, world_from_a.position, world_from_b.position);
        });
}

// One of two objects, without a branch, which a processor could not predict, and not by way of memory.
template <typename T>
T& choose(unsigned second, T& a, T& b) {
    const auto at_a = reinterpret_cast<std::uintptr_t>(&a), at_b = reinterpret_cast<std::uintptr_t>(&b);
    return *reinterpret_cast<T*>(at_a ^ ((at_a ^ at_b) & (std::uintptr_t{0} - second)));
}

// By the face that the cache holds, if it is still the closest; the same bits as measure_by_ends(). It chooses the
// shape that owns the face's edge, and computes in that shape's terms. The result is the caller's: a local one would be
// copied.
template <int N>
[[gnu::always_inline]] inline bool measure_kept_face(const Shape& a, const Pose& world_from_a, const Shape& b,
                                                     const Pose& world_from_b, SimplexCache& cache,
                                                     DistanceResult& result) {
    const CorePair pair = make_core_pair(a, world_from_a, b, world_from_b);
    const VertexPair first = cache.pairs[0], second = cache.pairs[1];
    const unsigned is_b = first.a == second.a;
    const Shape &own = choose(is_b, a, b), &other = choose(is_b, b, a);
    const Pose &world_from_own = choose(is_b, world_from_a, world_from_b),
               &world_from_other = choose(is_b, world_from_b, world_from_a);
    const Core owner = make_core(own, world_from_own.rotation),
               other_core = make_core(other, world_from_other.rotation);
    if (!is_valid(pair, a, b) || !are_ends(owner, is_b, first, second)) return false;
    const double sign = kSign[is_b], offset_x = sign * pair.offset.x, offset_y = sign * pair.offset.y;
    const OwnedFace face = find_face<N>(owner, other_core, offset_x, offset_y, is_b, own_vertex(is_b, first));
    const FaceMeasure<double> measured = measure(face.numbers, offset_x, offset_y);
    CoreDistance core;
    const Foot foot = write_face(core, face, measured, error_bound(pair));
    if (foot != Foot::inside || !(core.lower > 0.0)) return false;
    core.iterations = 1;
    store(core, cache);
    const DVec2 outward{measured.normal_x, measured.normal_y};
    write_numbers(result, core, double{a.radius()} + double{b.radius()});
    write_surface_point(choose(is_b, result.point_a, result.point_b), world_from_own.position,
                        {measured.own_x, measured.own_y}, own.radius(), outward);
    write_surface_point(choose(is_b, result.point_b, result.point_a), world_from_other.position,
                        {face.numbers.other_x, face.numbers.other_y}, other.radius(), -outward);
    return true;
}

template <int N>
[[gnu::noinline]] DistanceResult distance_by_kept_face(const Shape& a, const Pose& world_from_a, const Shape& b,
                                                       const Pose& world_from_b, SimplexCache* cache) {
    DistanceResult result;
    if (!measure_kept_face<N>(a, world_from_a, b, world_from_b, *cache, result))
        result = distance_of_any(a, world_from_a, b, world_from_b, cache);
    return result;
}

bool is_small(const Shape& shape) { return shape.vertex_count() <= Shape::kInlineVertices && shape.is_convex(); }

}  // namespace

DistanceResult distance(const Shape& a, const Pose& world_from_a, const Shape& b, const Pose& world_from_b,
                        SimplexCache* cache) noexcept {
    if (a.vertex_count() == 1 && b.vertex_count() == 1)
        return distance_of_circles(a, world_from_a, b, world_from_b, cache);
    if (cache && cache->count == 2 && is_small(a) && is_small(b))
        return std::max(a.vertex_count(), b.vertex_count()) <= 4
                   ? distance_by_kept_face<4>(a, world_from_a, b, world_from_b, cache)
                   : distance_by_kept_face<8>(a, world_from_a, b, world_from_b, cache);
    return distance_of_any(a, world_from_a, b, world_from_b, cache);
}

}  // namespace tumble
