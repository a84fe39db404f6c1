// distance(): validity, the distance of the cores, then the radii.
#include "tumble/distance.hpp"

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

}  // namespace

DistanceResult distance(const Shape& a, const Pose& world_from_a, const Shape& b, const Pose& world_from_b,
                        SimplexCache* cache) noexcept {
    if (a.vertex_count() == 1 && b.vertex_count() == 1)
        return distance_of_circles(a, world_from_a, b, world_from_b, cache);
    const CorePair pair = make_core_pair(a, world_from_a, b, world_from_b);
    if (!is_valid(pair, a, b)) return invalid_result();
    return measure_cores(
        pair, cache, [&](const CoreDistance& core) __attribute__((always_inline)) {
            return make_result(core, a, b, world_from_a.position, world_from_b.position);
        });
}

}  // namespace tumble
