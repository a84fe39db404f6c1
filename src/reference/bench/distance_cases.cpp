// Distances one by one and in batches.
#include <memory>

#include "reference/bench/case_makers.hpp"
#include "reference/bench/v3_runs.hpp"
#include "reference/box2d/b2_types.hpp"

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
                        [=] { return run_box2d(pairs->theirs, is_warm); }, v3_distances(pairs->ours, is_warm)};
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
                        [=] { return run_box2d(pairs->theirs, false); }, v3_distances(pairs->ours, false)};
            }};
}

}  // namespace tumble::reference
