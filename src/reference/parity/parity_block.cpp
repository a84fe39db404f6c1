#include "reference/parity/parity_block.hpp"

#include <mutex>
#include <vector>

#include "reference/box2d/b2_types.hpp"
#include "reference/query/random.hpp"

namespace tumble::reference {

namespace {

constexpr int kLargestExact = 64;  // vertices of a core; beyond, the certificate is checked

bool has_radii(const PairQuery& query) { return query.a.radius() > 0.0f || query.b.radius() > 0.0f; }

// The queries of a block, those with radii twice: bare cores first, as they are second.
struct Inquiries {
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

DistanceResult ask_tumble(const PairQuery& query) { return distance(query.a, query.pose_a, query.b, query.pose_b); }

// The same bits, a pair a lane.
std::vector<DistanceResult> ask_tumble(const std::vector<PairQuery>& queries) {
    std::vector<PosedPair> pairs;
    pairs.reserve(queries.size());
    for (const PairQuery& query : queries) pairs.push_back({&query.a, query.pose_a, &query.b, query.pose_b});
    std::vector<DistanceResult> answers(pairs.size());
    distance_batch(pairs, answers);
    return answers;
}

// One block at a time. Bare cores are asked without `useRadii`, which would call
// everything within 1.2e-7 m an overlap.
std::vector<std::optional<B2Distance>> ask_box2d(const std::vector<PairQuery>& queries) {
    const std::scoped_lock lock(b2_query_lock);
    std::vector<std::optional<B2Distance>> answers;
    answers.reserve(queries.size());
    for (const PairQuery& query : queries) answers.push_back(b2_distance(query, has_radii(query)));
    return answers;
}

bool is_large(const PairQuery& query) {
    return query.a.vertex_count() > kLargestExact || query.b.vertex_count() > kLargestExact;
}

// Exact sides of a block's queries in their order: the cores of a pair with radii are measured once.
class ExactSource {
public:
    ExactSide side(const PairQuery& query, const DistanceResult& ours, std::uint64_t index) {
        if (is_large(query)) return ExactSide::of_certificate(query, ours);
        if (!cores_ || index != index_) cores_.emplace(query);
        index_ = index;
        return ExactSide::of_distance(cores_->with_radii(query.a.radius(), query.b.radius()));
    }

private:
    std::optional<ExactDistance> cores_;
    std::uint64_t index_ = 0;
};

bool is_sampled(std::uint64_t index, const ParityOptions& options) {
    return index < options.checked_first || Random(~options.seed, index).chance(options.checked_share);
}

void judge(ParityRow& row, const Inquiries& inquiries, const ParityOptions& options) {
    const std::vector<DistanceResult> ours = ask_tumble(inquiries.queries);
    const std::vector<std::optional<B2Distance>> box2d = ask_box2d(inquiries.queries);
    ExactSource source;
    for (std::size_t i = 0; i < inquiries.queries.size(); ++i) {
        const std::uint64_t index = inquiries.indices[i];
        const Comparison comparison{inquiries.queries[i], ours[i], box2d[i]};
        std::optional<ExactSide> exact;
        if (is_sampled(index, options) || needs_exact_check(comparison))
            exact = source.side(comparison.query, comparison.ours, index);
        add_comparison(row, comparison, exact ? &*exact : nullptr, {options.seed, index});
    }
}

}  // namespace

ParityRow compare_family_block(const PairFamily& family, std::uint64_t begin, std::uint64_t end,
                               const ParityOptions& options) {
    ParityRow row;
    row.name = family.name;
    row.pairs = end - begin;
    Inquiries inquiries;
    for (std::uint64_t index = begin; index < end; ++index) {
        const PairQuery query = family.generate(options.seed, index);
        if (family.kind == FamilyKind::invalid) {
            add_invalid_comparison(row, query, ask_tumble(query), {options.seed, index});
        } else {
            inquiries.add(query, index);
        }
    }
    judge(row, inquiries, options);
    return row;
}

ParityRow compare_queries(std::span<const PairQuery> queries, std::uint64_t first_index, const ParityOptions& options) {
    ParityRow row;
    row.pairs = queries.size();
    Inquiries inquiries;
    for (std::size_t i = 0; i < queries.size(); ++i) inquiries.add(queries[i], first_index + i);
    judge(row, inquiries, options);
    return row;
}

}  // namespace tumble::reference
