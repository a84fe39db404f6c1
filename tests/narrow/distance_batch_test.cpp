// A batch gives the bits of distance(), whatever the other pairs are.
#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "support/distance_results.hpp"
#include "support/random_pairs.hpp"

using namespace tumble;
using namespace tumble_test;

namespace {

std::vector<Pair> random_pairs(unsigned seed, int count) {
    PairSource source(seed);
    std::vector<Pair> pairs;
    for (int sample = 0; sample < count; ++sample) {
        Pair pair = sample % 2 ? source.near_pair() : source.pair();
        if (sample % 5 == 0) pair.a = make_box({1, static_cast<float>(source.uniform(0.1, 2.0))}, 0.05f);
        if (sample % 7 == 0) pair.b = make_circle(static_cast<float>(source.uniform(0.0, 1.0)));
        if (sample % 11 == 0) pair.pose_b.rotation = pair.pose_a.rotation;
        pairs.push_back(pair);
    }
    return pairs;
}

std::vector<PosedPair> posed(const std::vector<Pair>& pairs) {
    std::vector<PosedPair> result;
    for (const Pair& pair : pairs) result.push_back({&pair.a, pair.pose_a, &pair.b, pair.pose_b});
    return result;
}

DistanceResult alone(const PosedPair& pair) { return distance(*pair.a, pair.world_from_a, *pair.b, pair.world_from_b); }

// Results of an earlier query, all members of which the batch must overwrite.
std::vector<DistanceResult> used_results(std::size_t count) {
    const Shape box = make_box({1, 1});
    return std::vector<DistanceResult>(count, distance(box, {}, box, {{0.25, 0.5}, {}}));
}

void check_as_alone(const std::vector<PosedPair>& pairs) {
    std::vector<DistanceResult> results = used_results(pairs.size());
    distance_batch(pairs, results);
    for (std::size_t i = 0; i < pairs.size(); ++i) CHECK(have_same_bits(results[i], alone(pairs[i])));
}

}  // namespace

TEST_CASE("a batch gives the bits of single queries, in any order") {
    const std::vector<Pair> pairs = random_pairs(101, 20000);
    std::vector<PosedPair> in_order = posed(pairs);
    check_as_alone(in_order);
    std::mt19937_64 random(102);
    std::shuffle(in_order.begin(), in_order.end(), random);
    check_as_alone(in_order);
    std::ranges::stable_sort(in_order, {}, [](const PosedPair& pair) { return pair.a->vertex_count(); });
    check_as_alone(in_order);
}

TEST_CASE("an invalid pair does not change the results of its neighbours in a batch") {
    std::vector<Pair> pairs = random_pairs(103, 4000);
    PairSource source(104);
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    int invalid = 0;
    for (Pair& pair : pairs) {
        const int kind = source.below(12);
        if (kind == 0) pair.pose_a.position.x = nan;
        if (kind == 1) pair.pose_b.position.y = inf;
        if (kind == 2) pair.pose_b.rotation.s = static_cast<float>(nan);
        if (kind == 3) pair.a = Shape{};
        if (kind == 4) pair.b = Shape::from_raw(std::vector<Vec2>{{0, 0}, {1, 0}, {0, static_cast<float>(nan)}}, 0);
        invalid += measure(pair).status == DistanceStatus::invalid;
    }
    CHECK(invalid > 1000);
    CHECK(invalid < 2500);
    check_as_alone(posed(pairs));
}

TEST_CASE("a batch of any length, or of a single kind of pair, gives the bits of single queries") {
    const std::vector<Pair> pairs = random_pairs(105, 40);
    const std::vector<PosedPair> all = posed(pairs);
    for (std::size_t count = 0; count <= all.size(); ++count)
        check_as_alone({all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count)});
    for (const PosedPair& pair : all) check_as_alone(std::vector<PosedPair>(17, pair));
}

TEST_CASE("the shorter span decides how many pairs are answered") {
    const std::vector<Pair> pairs = random_pairs(106, 9);
    const std::vector<PosedPair> all = posed(pairs);
    std::vector<DistanceResult> results = used_results(12), untouched = results;
    distance_batch(all, std::span(results).first(5));
    for (std::size_t i = 0; i < results.size(); ++i)
        CHECK(have_same_bits(results[i], i < 5 ? alone(all[i]) : untouched[i]));
    distance_batch(std::span(all).first(2), results);
    CHECK(have_same_bits(results[2], alone(all[2])));
}
