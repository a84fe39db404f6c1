// Distance and overlap of compounds: pairs of parts in the order of their boxes' distance.
#include "tumble/compound.hpp"

#include <array>
#include <cstddef>
#include <limits>
#include <utility>

#include "narrow/distance_result.hpp"
#include "narrow/part_pairs.hpp"

namespace tumble {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Two compounds in world axes relative to A's position, as distance() sees each pair.
class PartPairs {
public:
    PartPairs(std::span<const Shape> a, const Pose& world_from_a, std::span<const Shape> b, const Pose& world_from_b)
        : a_(a),
          b_(b),
          world_from_a_(world_from_a),
          world_from_b_(world_from_b),
          memory_(buffer_.data(), buffer_.size()),
          boxes_a_(a, {{}, world_from_a.rotation}, &memory_),
          boxes_b_(b, {world_from_b.position - world_from_a.position, world_from_b.rotation}, &memory_) {}

    bool valid() const { return boxes_a_.valid && boxes_b_.valid; }

    // More than two error bounds of distance() for any pair: 16 u (RA + RB + |p|), and 4 u (rA + rB + |v|) for the radii.
    double rounding() const {
        return 0x1p-47 * (boxes_a_.reach + boxes_b_.reach + length(world_from_b_.position - world_from_a_.position));
    }

    DistanceResult query(std::int32_t part_a, std::int32_t part_b) const {
        return distance(a_[static_cast<std::size_t>(part_a)], world_from_a_, b_[static_cast<std::size_t>(part_b)], world_from_b_);
    }

    template <class Limit, class Query>
    void visit(Limit limit, Query visitor) {
        visit_part_pairs(boxes_a_, boxes_b_, &memory_, separation, limit, visitor);
    }

private:
    std::span<const Shape> a_;
    std::span<const Shape> b_;
    const Pose& world_from_a_;
    const Pose& world_from_b_;
    std::array<std::byte, kPartBytes> buffer_;
    std::pmr::monotonic_buffer_resource memory_;
    PartBoxes boxes_a_;
    PartBoxes boxes_b_;
};

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
    if (!pairs.valid()) return invalid_distance();
    CompoundDistance best;
    best.nearest.distance = best.lower = best.upper = kInfinity;
    bool valid = true;
    // A pair beyond the limit has a larger computed distance, not only a larger exact one.
    const double rounding = pairs.rounding();
    const auto limit = [&] { return best.upper + rounding; };
    pairs.visit(limit, [&](std::int32_t part_a, std::int32_t part_b) {
        const DistanceResult found = pairs.query(part_a, part_b);
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
    best.status = status_of(best.lower, best.upper);
    return best;
}

CompoundOverlap compound_overlap(std::span<const Shape> a, const Pose& world_from_a, std::span<const Shape> b,
                                 const Pose& world_from_b) {
    PartPairs pairs(a, world_from_a, b, world_from_b);
    CompoundOverlap result;
    if (!pairs.valid()) return result;
    result.status = DistanceStatus::separated;
    bool valid = true;
    const auto limit = [&] { return result.status == DistanceStatus::overlapping ? -kInfinity : 0.0; };
    pairs.visit(limit, [&](std::int32_t part_a, std::int32_t part_b) {
        const DistanceStatus status = pairs.query(part_a, part_b).status;
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
    return result;
}

}  // namespace tumble
