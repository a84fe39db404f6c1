// The pairs of two compounds' parts, nearest first in two levels: A's parts in the order of their bound to all of B,
// and for each of them B's parts in the order of their bound to it. Both lists end where no pair can change the answer.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "debug/check.hpp"
#include "narrow/compound/part_boxes.hpp"

namespace tumble {

// Enough for the boxes and lists of 250 parts of both together; more use the heap.
inline constexpr std::size_t kPartBytes = 8192;

struct PartCandidate {
    double bound = 0.0;
    std::int32_t part = 0;

    friend bool operator<(const PartCandidate& a, const PartCandidate& b) {
        return a.bound != b.bound ? a.bound < b.bound : a.part < b.part;
    }
};

using PartCandidates = std::pmr::vector<PartCandidate>;

// The parts whose bound is at most `limit`, lowest first.
template <class Bound>
void sort_candidates(const PartBoxes& parts, Bound bound, double limit, PartCandidates& candidates) {
    candidates.clear();
    for (std::size_t part = 0; part < parts.boxes.size(); ++part) {
        const double of_part = bound(parts.boxes[part]);
        TUMBLE_CHECK(!std::isnan(of_part));
        if (of_part <= limit) candidates.push_back({of_part, static_cast<std::int32_t>(part)});
    }
    std::sort(candidates.begin(), candidates.end());
}

// Calls query(part_a, part_b) for the pairs whose bound(box_a, box_b) is at most limit(), which queries may lower. The
// bound of a larger box must not be higher.
template <class Bound, class Limit, class Query>
void visit_part_pairs(const PartBoxes& a, const PartBoxes& b, std::pmr::memory_resource* memory, Bound bound,
                      Limit limit, Query query) {
    TUMBLE_CHECK(a.valid);
    TUMBLE_CHECK(b.valid);
    PartCandidates rows(memory), row(memory);
    rows.reserve(a.boxes.size());
    row.reserve(b.boxes.size());
    sort_candidates(
        a, [&](const Aabb& box) { return bound(box, b.all); }, limit(), rows);
    for (const PartCandidate& of_a : rows) {
        if (of_a.bound > limit()) break;
        const Aabb& box_a = a.boxes[static_cast<std::size_t>(of_a.part)];
        sort_candidates(
            b, [&](const Aabb& box) { return bound(box_a, box); }, limit(), row);
        for (const PartCandidate& of_b : row) {
            if (of_b.bound > limit()) break;
            query(of_a.part, of_b.part);
        }
    }
}

// Two compounds in world axes relative to A's position, as the queries of each pair see them.
class PartPairs {
public:
    PartPairs(std::span<const Shape> a, const Pose& world_from_a, std::span<const Shape> b, const Pose& world_from_b)
        : memory_(buffer_.data(), buffer_.size()),
          boxes_a_(a, {{}, world_from_a.rotation}, &memory_),
          boxes_b_(b, {world_from_b.position - world_from_a.position, world_from_b.rotation}, &memory_),
          sizes_(boxes_a_.reach + boxes_b_.reach + length(world_from_b.position - world_from_a.position)) {}

    bool are_valid() const { return boxes_a_.valid && boxes_b_.valid; }

    // Of the largest parts and the offset (m).
    double sizes() const { return sizes_; }

    // More than two error bounds of the distance of any pair grown by `target`: 16 u (RA + RB + |p|), and 4 u (rA + rB
    // + |v|) for the radii (m).
    double rounding(double target = 0.0) const { return 0x1p-47 * (sizes_ + target); }

    // As visit_part_pairs().
    template <class Bound, class Limit, class Query>
    void visit(Bound bound, Limit limit, Query query) {
        visit_part_pairs(boxes_a_, boxes_b_, &memory_, bound, limit, query);
    }

private:
    std::array<std::byte, kPartBytes> buffer_;
    std::pmr::monotonic_buffer_resource memory_;
    PartBoxes boxes_a_;
    PartBoxes boxes_b_;
    double sizes_;
};

}  // namespace tumble
