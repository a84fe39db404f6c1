// From core distance to the public result: radii subtracted last, witness points moved to the surfaces.
#pragma once

#include "debug/check.hpp"
#include "narrow/distance/core_distance.hpp"

namespace tumble {

DistanceResult invalid_result();

[[gnu::always_inline]] inline DistanceStatus status_of(double lower, double upper) {
    if (lower > 0.0) return DistanceStatus::separated;
    return upper < 0.0 ? DistanceStatus::overlapping : DistanceStatus::touching;
}

// Number by number, here and below: g++ 12 copies a struct as a whole that it has just written in halves, and stalls
// for 20 ns.
[[gnu::always_inline]] inline void write_numbers(DistanceResult& result, const CoreDistance& core, double radii) {
    const double rounding = radii > 0.0 ? 4.0 * kUnitRoundoff * (radii + std::abs(core.distance)) : 0.0;
    TUMBLE_CHECK(radii >= 0.0);
    TUMBLE_CHECK(core.lower <= core.upper);
    result.distance = core.distance - radii;
    result.lower = (core.lower - radii) - rounding;
    result.upper = (core.upper - radii) + rounding;
    result.normal.x = core.normal.x;
    result.normal.y = core.normal.y;
    result.certificate.direction.x = core.direction.x;
    result.certificate.direction.y = core.direction.y;
    result.certificate.pairs[0].a = core.pairs[0].a;
    result.certificate.pairs[0].b = core.pairs[0].b;
    result.certificate.pairs[1].a = core.pairs[1].a;
    result.certificate.pairs[1].b = core.pairs[1].b;
    result.certificate.pair_count = static_cast<std::uint8_t>(core.pair_count);
    result.certificate.cores_overlap = core.overlap;
    result.status = status_of(result.lower, result.upper);
    result.iterations = static_cast<std::uint16_t>(core.iterations);
    result.reached_cap = core.reached_cap;
}

// The point on a surface beyond a point of its core.
[[gnu::always_inline]] inline void write_surface_point(DVec2& point, DVec2 position, DVec2 on_core, double radius,
                                                       DVec2 outward) {
    point.x = position.x + (on_core.x + radius * outward.x);
    point.y = position.y + (on_core.y + radius * outward.y);
}

[[gnu::always_inline]] inline void write_result(DistanceResult& result, const CoreDistance& core, const Shape& a,
                                                const Shape& b, DVec2 position_a, DVec2 position_b) {
    const double radius_a = a.radius(), radius_b = b.radius();
    write_numbers(result, core, radius_a + radius_b);
    write_surface_point(result.point_a, position_a, core.on_a, radius_a, core.normal);
    write_surface_point(result.point_b, position_b, core.on_b, radius_b, -core.normal);
}

[[gnu::always_inline]] inline DistanceResult make_result(const CoreDistance& core, const Shape& a, const Shape& b,
                                                         DVec2 position_a, DVec2 position_b) {
    DistanceResult result;
    write_result(result, core, a, b, position_a, position_b);
    return result;
}

}  // namespace tumble
