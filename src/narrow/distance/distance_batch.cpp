// Many queries at once: one pair in each lane.
//
// Pairs of at most four, and of at most eight, vertices are collected until their lanes are full, and answered together
// by the formulas of one pair (feature_formulas.hpp). No lane reads another, so each answer has the bits of distance()
// whatever pairs are beside it. Pairs that the leading face does not decide, large ones, and a last group that does not
// fill its lanes are answered one by one.
#include <algorithm>

#include "debug/check.hpp"
#include "narrow/distance/distance_result.hpp"
#include "narrow/distance/measure_pairs.hpp"

namespace tumble {

namespace {

template <int N>
class Batch {
public:
    Batch(std::span<const PosedPair> pairs, std::span<DistanceResult> results) : pairs_(pairs), results_(results) {}

    void add(std::size_t index) {
        TUMBLE_CHECK(count_ < kPairs);
        TUMBLE_CHECK(index < results_.size());
        indices_[count_++] = index;
        if (count_ == kPairs) answer_all();
    }

    void answer_rest() {
        for (int i = 0; i < count_; ++i) answer_alone(indices_[i]);
        count_ = 0;
    }

private:
    void answer_alone(std::size_t index) {
        const PosedPair& pair = pairs_[index];
        results_[index] = distance(*pair.a, pair.world_from_a, *pair.b, pair.world_from_b);
    }

    void answer_all() {
        const Shape *shapes_a[kPairs], *shapes_b[kPairs];
        const Pose *poses_a[kPairs], *poses_b[kPairs];
        for (int lane = 0; lane < kPairs; ++lane) {
            const PosedPair& pair = pairs_[indices_[lane]];
            shapes_a[lane] = pair.a;
            shapes_b[lane] = pair.b;
            poses_a[lane] = &pair.world_from_a;
            poses_b[lane] = &pair.world_from_b;
        }
        TUMBLE_CHECK(count_ == kPairs);
        const MeasuredPairs<N> measured(CorePairs<N>(shapes_a, poses_a, shapes_b, poses_b));
        for (int lane = 0; lane < kPairs; ++lane) {
            const Shape &a = *shapes_a[lane], &b = *shapes_b[lane];
            if (measured.is_decided(lane) && are_radii_valid(a, b))
                write_result(results_[indices_[lane]], measured(lane, a, b), a, b, poses_a[lane]->position,
                             poses_b[lane]->position);
            else
                answer_alone(indices_[lane]);
        }
        count_ = 0;
    }

    std::span<const PosedPair> pairs_;
    std::span<DistanceResult> results_;
    std::size_t indices_[kPairs];
    int count_ = 0;
};

}  // namespace

void distance_batch(std::span<const PosedPair> pairs, std::span<DistanceResult> results) noexcept {
    Batch<4> small(pairs, results);
    Batch<8> larger(pairs, results);
    for (std::size_t i = 0; i < std::min(pairs.size(), results.size()); ++i) {
        const Shape &a = *pairs[i].a, &b = *pairs[i].b;
        const int most = std::max(a.vertex_count(), b.vertex_count()),
                  least = std::min(a.vertex_count(), b.vertex_count());
        const bool fits = least > 0 && most > 1 && most <= Shape::kInlineVertices && a.is_convex() && b.is_convex();
        if (!fits)
            results[i] = distance(a, pairs[i].world_from_a, b, pairs[i].world_from_b);
        else if (most <= 4)
            small.add(i);
        else
            larger.add(i);
    }
    small.answer_rest();
    larger.answer_rest();
}

}  // namespace tumble
