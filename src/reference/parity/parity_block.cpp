#include "reference/parity/parity_block.hpp"

#include <mutex>
#include <vector>

#include "debug/check.hpp"
#include "reference/box2d/b2_types.hpp"
#include "reference/box2d_v3/v3_queries.hpp"
#include "reference/query/random.hpp"

namespace tumble::reference {

namespace {

constexpr int kLargestExact = 64;  // vertices of a core; for larger ones the certificate is checked

bool has_radii(const PairQuery& query) { return query.a.radius() > 0.0f || query.b.radius() > 0.0f; }

// The queries of a block. A pair with radii gives two: the bare cores, then the pair itself.
struct QueryList {
    std::vector<PairQuery> queries;
    std::vector<std::uint64_t> indices;  // [queries.size()], of the pair

    void add(const PairQuery& query, std::uint64_t index) {
        if (has_radii(query)) push(query.without_radii(), index);
        push(query, index);
    }

private:
    void push(PairQuery query, std::uint64_t index) {
        queries.push_back(std::move(query));
        indices.push_back(index);
    }
};

DistanceResult query_tumble(const PairQuery& query) { return distance(query.a, query.pose_a, query.b, query.pose_b); }

// The same answers, bit for bit, by the batch with one pair per lane.
std::vector<DistanceResult> query_tumble(const std::vector<PairQuery>& queries) {
    std::vector<PosedPair> pairs;
    pairs.reserve(queries.size());
    for (const PairQuery& query : queries) pairs.push_back({&query.a, query.pose_a, &query.b, query.pose_b});
    std::vector<DistanceResult> answers(pairs.size());
    distance_batch(pairs, answers);
    return answers;
}

// Bare cores are queried without `useRadii`, with which Box2D reports everything within 1.2e-7 m as an overlap.
std::vector<std::optional<B2Distance>> query_opponent(const std::vector<PairQuery>& queries, Opponent opponent) {
    std::vector<std::optional<B2Distance>> answers;
    answers.reserve(queries.size());
    if (opponent == Opponent::box2d_v3) {
        for (const PairQuery& query : queries) answers.push_back(b2_v3_distance(query, has_radii(query)));
        return answers;
    }
    const std::scoped_lock lock(b2_query_lock);
    for (const PairQuery& query : queries) answers.push_back(b2_distance(query, has_radii(query)));
    return answers;
}

bool is_large(const PairQuery& query) {
    return query.a.vertex_count() > kLargestExact || query.b.vertex_count() > kLargestExact;
}

// The ground truth of a block's queries, in their order. The exact distance of the cores is computed once per pair.
class GroundTruthCache {
public:
    GroundTruth truth_of(const PairQuery& query, const DistanceResult& ours, std::uint64_t index) {
        if (is_large(query)) return GroundTruth::of_certificate(query, ours);
        if (!cores_ || index != index_) cores_.emplace(query);
        index_ = index;
        return GroundTruth::of_distance(cores_->with_radii(query.a.radius(), query.b.radius()));
    }

private:
    std::optional<ExactDistance> cores_;
    std::uint64_t index_ = 0;
};

bool is_sampled(std::uint64_t index, const ParityOptions& options) {
    return index < options.checked_first || Random(~options.seed, index).chance(options.checked_share);
}

void judge(ParityRow& row, const QueryList& list, const ParityOptions& options) {
    const std::vector<DistanceResult> ours = query_tumble(list.queries);
    const std::vector<std::optional<B2Distance>> box2d = query_opponent(list.queries, options.opponent);
    TUMBLE_CHECK(list.indices.size() == list.queries.size());
    TUMBLE_CHECK(ours.size() == list.queries.size());
    TUMBLE_CHECK(box2d.size() == list.queries.size());
    GroundTruthCache cache;
    for (std::size_t i = 0; i < list.queries.size(); ++i) {
        const std::uint64_t index = list.indices[i];
        const Comparison comparison{list.queries[i], ours[i], box2d[i]};
        std::optional<GroundTruth> exact;
        if (is_sampled(index, options) || needs_exact_check(comparison))
            exact = cache.truth_of(comparison.query, comparison.ours, index);
        add_comparison(row, comparison, exact ? &*exact : nullptr, {options.seed, index});
    }
}

}  // namespace

ParityRow compare_family_block(const PairFamily& family, std::uint64_t begin, std::uint64_t end,
                               const ParityOptions& options) {
    TUMBLE_CHECK(begin <= end);
    ParityRow row;
    row.name = family.name;
    row.pairs = end - begin;
    QueryList list;
    for (std::uint64_t index = begin; index < end; ++index) {
        const PairQuery query = family.generate(options.seed, index);
        if (family.kind == FamilyKind::invalid) {
            add_invalid_comparison(row, query, query_tumble(query), {options.seed, index});
        } else {
            list.add(query, index);
        }
    }
    judge(row, list, options);
    return row;
}

ParityRow compare_queries(std::span<const PairQuery> queries, std::uint64_t first_index, const ParityOptions& options) {
    ParityRow row;
    row.pairs = queries.size();
    QueryList list;
    for (std::size_t i = 0; i < queries.size(); ++i) list.add(queries[i], first_index + i);
    judge(row, list, options);
    return row;
}

}  // namespace tumble::reference
