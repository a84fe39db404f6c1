// Distance and overlap of compounds: pairs of parts in the order of their boxes' distance.
#include "tumble/compound.hpp"

#include <cstddef>
#include <limits>
#include <utility>

#include "debug/check.hpp"
#include "narrow/compound/part_pairs.hpp"
#include "narrow/distance/distance_result.hpp"

namespace tumble {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

const Shape& part_of(std::span<const Shape> parts, std::int32_t index) {
    return parts[static_cast<std::size_t>(index)];
}

CompoundDistance invalid_distance() {
    const DistanceResult invalid = invalid_result();
    CompoundDistance result;
    result.nearest = invalid;
    result.lower = result.upper = invalid.distance;
    return result;
}

}  // namespace

CompoundDistance compound_distance(std::span<const Shape> a, const Pose& world_from_a, std::span<const Shape> b,
                                   const Pose& world_from_b) {
    PartPairs pairs(a, world_from_a, b, world_from_b);
    if (!pairs.are_valid()) return invalid_distance();
    CompoundDistance best;
    best.nearest.distance = best.lower = best.upper = kInfinity;
    bool valid = true;
    // A pair beyond the limit has a larger computed distance, not only a larger exact one.
    const double rounding = pairs.rounding();
    const auto limit = [&] { return best.upper + rounding; };
    pairs.visit(separation, limit, [&](std::int32_t part_a, std::int32_t part_b) {
        const DistanceResult found = distance(part_of(a, part_a), world_from_a, part_of(b, part_b), world_from_b);
        ++best.queries;
        valid = valid && found.status != DistanceStatus::invalid;
        best.lower = std::min(best.lower, found.lower);
        best.upper = std::min(best.upper, found.upper);
        const bool comes_first = std::pair(part_a, part_b) < std::pair(best.part_a, best.part_b);
        if (found.distance > best.nearest.distance || (found.distance == best.nearest.distance && !comes_first)) return;
        best.nearest = found;
        best.part_a = part_a;
        best.part_b = part_b;
    });
    if (!valid) return invalid_distance();
    TUMBLE_CHECK(best.part_a >= 0);
    TUMBLE_CHECK(best.lower <= best.upper);
    best.status = status_of(best.lower, best.upper);
    return best;
}

CompoundOverlap compound_overlap(std::span<const Shape> a, const Pose& world_from_a, std::span<const Shape> b,
                                 const Pose& world_from_b) {
    PartPairs pairs(a, world_from_a, b, world_from_b);
    CompoundOverlap result;
    if (!pairs.are_valid()) return result;
    result.status = DistanceStatus::separated;
    bool valid = true;
    const auto limit = [&] { return result.status == DistanceStatus::overlapping ? -kInfinity : 0.0; };
    pairs.visit(separation, limit, [&](std::int32_t part_a, std::int32_t part_b) {
        const DistanceStatus status =
            distance(part_of(a, part_a), world_from_a, part_of(b, part_b), world_from_b).status;
        ++result.queries;
        valid = valid && status != DistanceStatus::invalid;
        const bool decides = status == DistanceStatus::overlapping ||
                             (status == DistanceStatus::touching && result.status == DistanceStatus::separated);
        if (!decides) return;
        result.status = status;
        result.part_a = part_a;
        result.part_b = part_b;
    });
    if (!valid) return {};
    TUMBLE_CHECK((result.part_a >= 0) == (result.status != DistanceStatus::separated));
    return result;
}

}  // namespace tumble
