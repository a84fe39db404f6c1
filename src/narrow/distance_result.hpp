// From core distance to the public result: radii subtracted last, witness points moved to the surfaces.
#pragma once

#include "narrow/witness.hpp"

namespace tumble {

DistanceResult invalid_result();

[[gnu::always_inline]] inline DistanceStatus status_of(double lower, double upper) {
    if (lower > 0.0) return DistanceStatus::separated;
    return upper < 0.0 ? DistanceStatus::overlapping : DistanceStatus::touching;
}

[[gnu::always_inline]] inline DistanceResult make_result(const CorePair& pair, const CoreDistance& core, const Shape& a,
                                                         const Shape& b, DVec2 position_a, DVec2 position_b) {
    const double radius_a = a.radius(), radius_b = b.radius(), radii = radius_a + radius_b;
    const double rounding = radii > 0.0 ? 4.0 * kUnitRoundoff * (radii + std::abs(core.distance)) : 0.0;
    const CoreWitness witness = core_witness(pair, core);
    DistanceResult result;
    result.distance = core.distance - radii;
    result.lower = (core.lower - radii) - rounding;
    result.upper = (core.upper - radii) + rounding;
    result.point_a = position_a + (witness.a + radius_a * core.normal);
    result.point_b = position_b + (witness.b - radius_b * core.normal);
    result.normal = core.normal;
    result.certificate = {
        core.direction, {core.pairs[0], core.pairs[1]}, static_cast<std::uint8_t>(core.pair_count), core.overlap};
    result.status = status_of(result.lower, result.upper);
    result.iterations = static_cast<std::uint16_t>(core.iterations);
    result.reached_cap = core.reached_cap;
    return result;
}

}  // namespace tumble
