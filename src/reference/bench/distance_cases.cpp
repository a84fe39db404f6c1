// Distances one by one and in batches.
#include <memory>

#include "reference/bench/case_makers.hpp"
#include "reference/box2d/b2_types.hpp"
#include "reference/box2d_v3/v3_queries.hpp"

namespace tumble::reference {

namespace {

struct DistancePairs {
    std::vector<BenchPair> ours;
    Proxies proxies;
    struct Query {
        b2DistanceInput input;
        b2SimplexCache cache;
    };
    std::vector<Query> theirs;

    explicit DistancePairs(std::vector<BenchPair> pairs) : ours(std::move(pairs)), proxies(vertex_total(ours)) {
        for (const BenchPair& pair : ours) {
            Query& query = theirs.emplace_back();
            query.input = {proxies.make(pair.a), proxies.make(pair.b), to_b2(pair.pose_a), to_b2(pair.pose_b), true};
            query.cache.count = 0;
        }
    }
};

// The same pairs for Box2D v3: empty if this build lacks it, or a core has too many vertices.
struct V3Pairs {
    struct Query {
        V3Points a, b;
        box2d_v3::Place place;
        box2d_v3::Cache cache{};
    };
    std::vector<Query> queries;

    explicit V3Pairs(const std::vector<BenchPair>& pairs) {
        if (!has_box2d_v3()) return;
        for (const BenchPair& pair : pairs) {
            queries.push_back({V3Points(pair.a), V3Points(pair.b), relative_place(pair.pose_a, pair.pose_b)});
            if (queries.back().a.fits() && queries.back().b.fits()) continue;
            queries.clear();
            return;
        }
    }
};

// From two poses, as the others: the relative pose is part of the query.
double run_v3(const std::vector<BenchPair>& pairs, std::vector<V3Pairs::Query>& queries, bool is_warm) {
    double sum = 0.0;
    for (std::size_t i = 0; i < queries.size(); ++i) {
        V3Pairs::Query& query = queries[i];
        query.place = relative_place(pairs[i].pose_a, pairs[i].pose_b);
        sum +=
            double{box2d_v3::distance(query.a.get(), query.b.get(), query.place, true, is_warm ? &query.cache : nullptr)
                       .distance};
    }
    return sum;
}

// Empty if there are no queries.
QueryRun v3_run(const std::shared_ptr<DistancePairs>& pairs, bool is_warm) {
    const auto theirs = std::make_shared<V3Pairs>(pairs->ours);
    if (theirs->queries.empty()) return {};
    return [=] { return run_v3(pairs->ours, theirs->queries, is_warm); };
}

double run_tumble(std::vector<BenchPair>& pairs, bool is_warm) {
    double sum = 0.0;
    for (BenchPair& pair : pairs)
        sum += distance(pair.a, pair.pose_a, pair.b, pair.pose_b, is_warm ? &pair.cache : nullptr).distance;
    return sum;
}

double run_box2d(std::vector<DistancePairs::Query>& queries, bool is_warm) {
    double sum = 0.0;
    for (DistancePairs::Query& query : queries) {
        if (!is_warm) query.cache.count = 0;
        b2DistanceOutput output;
        b2Distance(&output, &query.cache, &query.input);
        sum += output.distance;
    }
    return sum;
}

}  // namespace

QueryCase distance_case(const std::string& name, BenchKind kind_a, BenchKind kind_b, double gap, bool is_warm) {
    return {name + (is_warm ? " warm" : " cold"), [=](int count, std::uint64_t seed) -> QueryRuns {
                const auto pairs = std::make_shared<DistancePairs>(random_pairs(kind_a, kind_b, gap, count, seed));
                return {[=] { return run_tumble(pairs->ours, is_warm); },
                        [=] { return run_box2d(pairs->theirs, is_warm); }, v3_run(pairs, is_warm)};
            }};
}

QueryCase batch_case(const std::string& name, BenchKind kind, double gap) {
    return {name, [=](int count, std::uint64_t seed) -> QueryRuns {
                const auto pairs = std::make_shared<DistancePairs>(random_pairs(kind, kind, gap, count, seed));
                std::vector<PosedPair> posed;
                for (const BenchPair& pair : pairs->ours) posed.push_back({&pair.a, pair.pose_a, &pair.b, pair.pose_b});
                const auto results = std::make_shared<std::vector<DistanceResult>>(posed.size());
                return {[=] {
                            distance_batch(posed, *results);
                            double sum = 0.0;
                            for (const DistanceResult& result : *results) sum += result.distance;
                            return sum;
                        },
                        [=] { return run_box2d(pairs->theirs, false); }, v3_run(pairs, false)};
            }};
}

}  // namespace tumble::reference
