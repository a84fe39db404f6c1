// Best first in two levels: A's parts in the order of their boxes' distance from all of B, and for each of them B's
// parts in the order of theirs; both lists end where no pair can change the answer any more.
#include "tumble/compound.hpp"

#include <array>
#include <cstddef>
#include <limits>
#include <utility>

#include "narrow/distance_result.hpp"
#include "narrow/part_boxes.hpp"

namespace tumble {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kStackBytes = 8192;  // for the boxes and lists of 250 parts of both together, then the heap

struct Candidate {
    double bound = 0.0;
    std::int32_t part = 0;

    friend bool operator<(const Candidate& a, const Candidate& b) {
        return a.bound != b.bound ? a.bound < b.bound : a.part < b.part;
    }
};

using Candidates = std::pmr::vector<Candidate>;

// The parts whose boxes come nearer to `box` than `limit`, nearest first.
void sort_candidates(const PartBoxes& parts, const Aabb& box, double limit, Candidates& candidates) {
    candidates.clear();
    for (std::size_t part = 0; part < parts.boxes.size(); ++part) {
        const double bound = separation(box, parts.boxes[part]);
        if (bound <= limit) candidates.push_back({bound, static_cast<std::int32_t>(part)});
    }
    std::sort(candidates.begin(), candidates.end());
}

// Calls query(part_a, part_b) for the pairs whose bound is at most limit(), which may sink meanwhile.
template <class Limit, class Query>
void visit_pairs(const PartBoxes& a, const PartBoxes& b, std::pmr::memory_resource* memory, Limit limit, Query query) {
    Candidates rows(memory), row(memory);
    rows.reserve(a.boxes.size());
    row.reserve(b.boxes.size());
    sort_candidates(a, b.all, limit(), rows);
    for (const Candidate& of_a : rows) {
        if (of_a.bound > limit()) break;
        sort_candidates(b, a.boxes[static_cast<std::size_t>(of_a.part)], limit(), row);
        for (const Candidate& of_b : row) {
            if (of_b.bound > limit()) break;
            query(of_a.part, of_b.part);
        }
    }
}

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
        visit_pairs(boxes_a_, boxes_b_, &memory_, limit, visitor);
    }

private:
    std::span<const Shape> a_;
    std::span<const Shape> b_;
    const Pose& world_from_a_;
    const Pose& world_from_b_;
    std::array<std::byte, kStackBytes> buffer_;
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
