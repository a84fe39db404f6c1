#include "narrow/cast/cast_result.hpp"

#include <limits>

#include "debug/check.hpp"
#include "narrow/cores/error_bound.hpp"

namespace tumble {

namespace {

// The point of A's core at the feature: on the edge between its two vertices, or the vertex.
DVec2 core_point(const Core& a, const CastFeature& feature) {
    const DVec2 from = a.point(feature.from.a);
    return feature.from.a == feature.to.a ? from : from + feature.along * a.edge(feature.from.a, feature.to.a);
}

// The hit at a contact, at most at the end of the motion.
CastResult hit_at(const CastContact& contact, std::int32_t iterations, const Core& a, double radius_a,
                  DVec2 position_a) {
    const CastFeature& feature = contact.feature;
    CastResult result;
    result.status = CastStatus::hit;
    TUMBLE_CHECK(contact.fraction >= 0.0);
    result.fraction = std::fmin(contact.fraction, 1.0);
    result.lower = contact.lower;
    result.upper = contact.upper;
    result.normal = feature.normal;
    result.point = position_a + (core_point(a, feature) + radius_a * feature.normal);
    result.iterations = iterations;
    return result;
}

}  // namespace

CastResult invalid_cast() {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return {CastStatus::invalid, nan, nan, nan, {nan, nan}, {nan, nan}, 0, false};
}

bool is_valid_motion(DVec2 translation) {
    return std::abs(translation.x) <= kLargestScale && std::abs(translation.y) <= kLargestScale;
}

CastPath make_path(const CorePair& pair, DVec2 translation, double reach) {
    const double distance_to_go = length(translation);
    const double error = 16.0 * kUnitRoundoff * (pair.scale + reach);
    return {translation, distance_to_go >= kSmallestScale ? distance_to_go : 0.0, reach, error};
}

CastResult cast_result(const ClippedPath& clipped, const CastPath& path, const Core& a, double radius_a,
                       DVec2 position_a) {
    const double gap = clipped.start_distance - path.reach;
    if (gap < -path.error) return overlapped(clipped.faces);
    const bool is_at_target = gap <= path.error;
    if (is_at_target ? !clipped.approaches : !(clipped.first.lower <= 1.0)) return missed(clipped.faces);
    if (!is_at_target) return hit_at(clipped.first, clipped.faces, a, radius_a, position_a);
    TUMBLE_CHECK(clipped.start_rate > 0.0);
    const double upper = 2.0 * path.error / clipped.start_rate;
    return hit_at({0.0, 0.0, upper, clipped.start_rate, clipped.start}, clipped.faces, a, radius_a, position_a);
}

}  // namespace tumble
