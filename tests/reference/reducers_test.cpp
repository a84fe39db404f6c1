// Every hard family by each of the distance subalgorithms and by exhaustive search, with the checks of distance()
// itself. The environment variable TUMBLE_PAIRS sets the pairs per family (10 000); families of large polygons take a
// fiftieth. TUMBLE_FAMILY selects a single family.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "narrow/distance/distance_result.hpp"
#include "reference/exact/certificate.hpp"
#include "reference/exact/exact_distance.hpp"
#include "reference/families/pair_families.hpp"
#include "reference/parity/parallel_blocks.hpp"
#include "reference/query/random.hpp"
#include "support/distance_results.hpp"

using namespace tumble;
using namespace tumble::reference;
using namespace tumble_test;

namespace {

constexpr std::uint64_t kSeed = 20261122;
constexpr std::uint64_t kBlock = 100;
constexpr std::uint64_t kUsualPairs = 10000;

using Answer = DistanceResult (*)(const PairQuery&);

struct Method {
    const char* name;
    Answer answer;
};

template <SubAlgorithm kBy>
DistanceResult by_gjk(const PairQuery& q) {
    return gjk_distance(q.a, q.pose_a, q.b, q.pose_b, kBy);
}

// The distance by all vertices and edges, and the depth by all faces, without the GJK loop.
DistanceResult by_exhaustive_search(const PairQuery& q) {
    const CorePair pair = make_core_pair(q.a, q.pose_a, q.b, q.pose_b);
    if (!is_valid(pair, q.a, q.b)) return invalid_result();
    const CoreDistance core = conclude(pair, exhaustive_search(pair, {}));
    return make_result(core, q.a, q.b, q.pose_a.position, q.pose_b.position);
}

constexpr Method kMethods[] = {{"voronoi", by_gjk<SubAlgorithm::voronoi>},
                               {"johnson", by_gjk<SubAlgorithm::johnson>},
                               {"signed_volumes", by_gjk<SubAlgorithm::signed_volumes>},
                               {"exhaustive", by_exhaustive_search}};

struct Counts {
    std::uint64_t wrong = 0, rejected = 0, disagreeing = 0, same = 0, pairs = 0, separated = 0;
    std::string example;

    void note(std::uint64_t& count, const std::string& what, const PairQuery& query) {
        if (count++ == 0 && example.empty()) example = what + ": " + to_hex(query);
    }
    void merge(const Counts& later) {
        wrong += later.wrong;
        rejected += later.rejected;
        disagreeing += later.disagreeing;
        same += later.same;
        pairs += later.pairs;
        separated += later.separated;
        if (example.empty()) example = later.example;
    }
};

bool is_right(const PairQuery& query, const DistanceResult& answer, const ExactDistance& exact) {
    return fit_of(query, answer, exact) != BoundsFit::wrong && is_status_right(answer.status, exact);
}

void check_pair(Counts& counts, const PairFamily& family, std::uint64_t index) {
    const PairQuery query = family.generate(kSeed, index);
    const DistanceResult one = distance(query.a, query.pose_a, query.b, query.pose_b);
    std::optional<ExactDistance> exact;
    if (family.kind == FamilyKind::exact) exact.emplace(query);
    for (const Method& method : kMethods) {
        const DistanceResult other = method.answer(query);
        ++counts.pairs;
        if (family.kind == FamilyKind::invalid) {
            if (other.status != DistanceStatus::invalid) counts.note(counts.wrong, method.name, query);
            continue;
        }
        if (exact && !is_right(query, other, *exact)) counts.note(counts.wrong, method.name, query);
        if (check_certificate(query, other) != CertificateVerdict::accepted)
            counts.note(counts.rejected, method.name, query);
        if (!(std::max(one.lower, other.lower) <= std::min(one.upper, other.upper)))
            counts.note(counts.disagreeing, method.name, query);
        counts.same += one.distance == other.distance && one.normal == other.normal;
        counts.separated += one.status == DistanceStatus::separated;
    }
}

Counts check_family(const PairFamily& family) {
    const std::uint64_t pairs = pairs_of(family, kUsualPairs);
    Counts counts;
    run_blocks<Counts>((pairs + kBlock - 1) / kBlock, 0,
                       [&](std::size_t block) {
                           Counts part;
                           for (std::uint64_t i = block * kBlock; i < std::min((block + 1) * kBlock, pairs); ++i)
                               check_pair(part, family, i);
                           return part;
                       },
                       [&](std::size_t, const Counts& part) { counts.merge(part); });
    return counts;
}

// A polygon of four equal quarters. The edges of a quarter are vectors of coprime integers, those with the smallest
// sums, sorted by angle. Its coordinates are integers below 2^24.
std::vector<Vec2> lattice_polygon(std::size_t edges_in_quarter) {
    std::vector<std::array<int, 2>> edges;
    for (int sum = 2; edges.size() < edges_in_quarter; ++sum)
        for (int x = 1; x < sum && edges.size() < edges_in_quarter; ++x)
            if (std::gcd(x, sum) == 1) edges.push_back({x, sum - x});
    std::ranges::sort(edges, [](const auto& p, const auto& q) { return p[0] * q[1] > p[1] * q[0]; });
    std::vector<Vec2> points;
    std::array<int, 2> at{0, 0};
    for (int quarter = 0; quarter < 4; ++quarter)
        for (auto& [x, y] : edges) {
            points.push_back({static_cast<float>(at[0]), static_cast<float>(at[1])});
            at = {at[0] + x, at[1] + y};
            std::tie(x, y) = std::pair(-y, x);
        }
    return points;
}

}  // namespace

TEST_CASE("by every subalgorithm the bounds, status and certificates of every family are right") {
    Counts total;
    for (const PairFamily& family : pair_families()) {
        if (!is_family_selected(family.name)) continue;
        const Counts counts = check_family(family);
        INFO(family.name << ": " << counts.example);
        CHECK(counts.wrong == 0);
        CHECK(counts.rejected == 0);
        CHECK(counts.disagreeing == 0);
        total.merge(counts);
    }
    if (is_every_family_selected()) {
        CHECK(10 * total.same > 9 * total.pairs);  // equal bits wherever a single feature is closest
        CHECK(10 * total.separated > 3 * total.pairs);
        CHECK(10 * total.separated < 7 * total.pairs);
    }
    MESSAGE(total.pairs << " answers, " << total.same << " of them distance()'s bits");
}

TEST_CASE("a batch of each family has the bits of distance()") {
    std::uint64_t pairs = 0;
    for (const PairFamily& family : pair_families()) {
        if (!is_family_selected(family.name)) continue;
        std::vector<PairQuery> queries;
        for (std::uint64_t i = 0; i < pairs_of(family, kUsualPairs); ++i) queries.push_back(family.generate(kSeed, i));
        std::vector<PosedPair> posed;
        for (const PairQuery& q : queries) posed.push_back({&q.a, q.pose_a, &q.b, q.pose_b});
        std::vector<DistanceResult> results(posed.size());
        distance_batch(posed, results);
        INFO(family.name);
        for (std::size_t i = 0; i < queries.size(); ++i) {
            const PairQuery& q = queries[i];
            if (!have_same_bits(results[i], distance(q.a, q.pose_a, q.b, q.pose_b))) FAIL_CHECK(to_hex(q));
        }
        pairs += queries.size();
    }
    CHECK(pairs > 1000);
}

TEST_CASE("the answers of every subalgorithm to the regression cases are right and certified") {
    REQUIRE_FALSE(regression_cases().empty());
    for (const RegressionCase& regression : regression_cases()) {
        const PairQuery& q = regression.query;
        const ExactDistance exact(q);
        for (const Method& method : kMethods) {
            INFO(regression.name << " by " << method.name << ": " << to_hex(q));
            const DistanceResult answer = method.answer(q);
            CHECK(is_right(q, answer, exact));
            CHECK(check_certificate(q, answer) == CertificateVerdict::accepted);
        }
    }
}

// The nearest vertex joins two edges of A - B that are in line within 2e-8 rad. |v| is the same within rounding at the
// vertex, on either edge and on the chord over both, but the direction of one edge alone proves it.
TEST_CASE("the lower bound is tight at the corner of two edges that are almost in line") {
    const PairFamily* family = find_pair_family("almost_parallel");
    REQUIRE(family);
    for (const std::uint64_t index : {194414, 246018}) {
        const PairQuery query = family->generate(kSeed, index);
        const ExactDistance exact(query);
        for (const Method& method : kMethods) {
            INFO("pair " << index << " by " << method.name);
            CHECK(fit_of(query, method.answer(query), exact) == BoundsFit::near);
        }
    }
}

TEST_CASE("the trace has every iteration of the search for a better proof") {
    const PairFamily* family = find_pair_family("almost_parallel");
    REQUIRE(family);
    for (const std::uint64_t index : {194414, 246018}) {
        const PairQuery query = family->generate(kSeed, index);
        for (const SubAlgorithm by : {SubAlgorithm::voronoi, SubAlgorithm::johnson, SubAlgorithm::signed_volumes}) {
            const DistanceTrace trace = trace_distance(query.a, query.pose_a, query.b, query.pose_b, by);
            REQUIRE(!trace.result.reached_cap);
            CHECK(trace.steps.size() + 1 == trace.result.iterations);
            // One proof, of which each of the two subtracts the error bound. The loop alone proves 3e-9 m less.
            CHECK(trace.steps.back().lower >= trace.result.lower - core_error_bound(query));
            for (std::size_t i = 1; i < trace.steps.size(); ++i)
                CHECK(trace.steps[i].upper <= trace.steps[i - 1].upper);
        }
    }
}

TEST_CASE("the certificates of outlines of 65 532 vertices are accepted, by every subalgorithm and in a batch") {
    const Shape large = Shape::from_raw(lattice_polygon(16383), 0.0f), box = make_box({1.0f, 1.0f}, 0.1f);
    REQUIRE(large.vertex_count() == 65532);
    REQUIRE(large.is_convex());
    for (int sample = 0; sample < 6; ++sample) {
        Random random(kSeed, static_cast<std::uint64_t>(sample));
        const DVec2 direction = random.direction();
        const double gap = sample % 3 == 0 ? -1000.0 : 1e-3;
        PairQuery query{
            large, sample % 3 == 2 ? box : large, {{}, random.rotation()}, {1e7 * direction, random.rotation()}};
        DistanceResult one = distance(query.a, query.pose_a, query.b, query.pose_b);
        for (int approach = 0; approach < 20; ++approach) {
            query.pose_b.position += (gap - one.distance) * one.normal;
            one = distance(query.a, query.pose_a, query.b, query.pose_b);
        }
        INFO("sample " << sample << ", distance " << one.distance);
        CHECK(one.status == (gap < 0.0 ? DistanceStatus::overlapping : DistanceStatus::separated));
        CHECK_FALSE(one.reached_cap);
        CHECK(check_certificate(query, one) == CertificateVerdict::accepted);
        for (const Method& method : kMethods) {
            INFO(method.name);
            const DistanceResult other = method.answer(query);
            CHECK(check_certificate(query, other) == CertificateVerdict::accepted);
            CHECK(std::max(one.lower, other.lower) <= std::min(one.upper, other.upper));
        }
        const PosedPair posed{&query.a, query.pose_a, &query.b, query.pose_b};
        DistanceResult in_batch;
        distance_batch({&posed, 1}, {&in_batch, 1});
        CHECK(have_same_bits(in_batch, one));
    }
}
