// Many queries at once: a pair a lane.
//
// Pairs of at most four, and of at most eight, vertices are collected until their lanes are full. What takes the time, the
// look at all faces for the one of largest separation, is then done for all of them together, by the formulas of one
// pair; what that face says is measured as for one pair, by the same functions. So each answer has the bits of distance(),
// whatever stands beside it: no lane reads another. Pairs that the leading face does not decide, large ones, and the last
// ones of lanes that are not full are asked one by one.
#include <algorithm>

#include "narrow/distance_result.hpp"
#include "narrow/faces_of_pairs.hpp"
#include "narrow/measure_cores.hpp"

namespace tumble {

namespace {

// Vertices of what is answered in lanes. Eight octagons at once do not fit registers of 256 bits: 105 ns a pair, 85 alone.
constexpr int kMostInLanes = DoubleLanes<8>::kParts == 1 ? 8 : 4;

template <int N>
class Batch {
public:
    Batch(std::span<const PosedPair> pairs, std::span<DistanceResult> results) : pairs_(pairs), results_(results) {}

    void add(std::size_t index) {
        indices_[count_++] = index;
        if (count_ == N) answer_all();
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
        const Shape *shapes_a[N], *shapes_b[N];
        const Pose *poses_a[N], *poses_b[N];
        double offsets_x[N], offsets_y[N];
        for (int lane = 0; lane < N; ++lane) {
            const PosedPair& query = pairs_[indices_[lane]];
            shapes_a[lane] = query.a;
            shapes_b[lane] = query.b;
            poses_a[lane] = &query.world_from_a;
            poses_b[lane] = &query.world_from_b;
            offsets_x[lane] = query.world_from_b.position.x - query.world_from_a.position.x;
            offsets_y[lane] = query.world_from_b.position.y - query.world_from_a.position.y;
        }
        const CoreOfPairs<N> a(shapes_a, poses_a), b(shapes_b, poses_b);
        const FacesOfPairs<N> faces(a, b, load_lanes(offsets_x), load_lanes(offsets_y));
        for (int lane = 0; lane < N; ++lane)
            if (!answer(lane, faces)) answer_alone(indices_[lane]);
        count_ = 0;
    }

    // False where the leading face does not decide.
    TUMBLE_LANE_FUNCTION bool answer(int lane, const FacesOfPairs<N>& faces) {
        const PosedPair& query = pairs_[indices_[lane]];
        const CorePair pair = make_core_pair(*query.a, query.world_from_a, *query.b, query.world_from_b);
        if (!faces.has_leading(lane) || !is_valid(pair, *query.a, *query.b)) return false;
        const OwnedFace face = faces.leading(lane, pair);
        CoreDistance core;
        core.iterations = 2;
        const Foot foot = measure_by_face(pair, face, core);
        const Decision decision = decide(foot, faces.leads_alone(lane), core);
        if (decision == Decision::none) return false;
        if (decision == Decision::vertex &&
            !measure_by_vertex<N>(pair, {turn<N>(pair.a), turn<N>(pair.b)}, end_of(face, foot), core))
            return false;
        write_result(results_[indices_[lane]], core, *query.a, *query.b, query.world_from_a.position, query.world_from_b.position);
        return true;
    }

    std::span<const PosedPair> pairs_;
    std::span<DistanceResult> results_;
    std::size_t indices_[N];
    int count_ = 0;
};

}  // namespace

void distance_batch(std::span<const PosedPair> pairs, std::span<DistanceResult> results) noexcept {
    Batch<4> small(pairs, results);
    Batch<8> larger(pairs, results);
    for (std::size_t i = 0; i < std::min(pairs.size(), results.size()); ++i) {
        const Shape &a = *pairs[i].a, &b = *pairs[i].b;
        const int most = std::max(a.vertex_count(), b.vertex_count()), least = std::min(a.vertex_count(), b.vertex_count());
        const bool fits = least > 0 && most > 1 && most <= kMostInLanes && a.is_convex() && b.is_convex();
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
