// The public query: guard, cores, radii.
#include "tumble/distance.hpp"

#include <limits>

#include "narrow/distance_result.hpp"

namespace tumble {

DistanceResult invalid_result() {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    DistanceResult result;
    result.distance = result.lower = result.upper = nan;
    result.point_a = result.point_b = result.normal = result.certificate.direction = {nan, nan};
    return result;
}

DistanceResult distance(const Shape& a, const Pose& world_from_a, const Shape& b, const Pose& world_from_b,
                        SimplexCache* cache) noexcept {
    const CorePair pair = make_core_pair(a, world_from_a, b, world_from_b);
    if (!is_valid(pair, a, b)) return invalid_result();
    const auto ignore = [](const Simplex&, const Closest&, const MinkowskiSupport&) {};
    const CoreDistance core = measure_cores<VoronoiRegions>(pair, cache, ignore);
    return make_result(pair, core, a, b, world_from_a.position, world_from_b.position);
}

}  // namespace tumble
