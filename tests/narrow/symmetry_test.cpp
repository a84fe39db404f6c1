// What must hold bit for bit: swap, exact translations, powers of two, quarter turns; and warm as cold.
#include <doctest/doctest.h>

#include "support/random_pairs.hpp"

using namespace tumble;
using namespace tumble_test;

namespace {

constexpr int kPairs = 10000;

Pair swapped(const Pair& pair) { return {pair.b, pair.pose_b, pair.a, pair.pose_a}; }

Shape scaled(const Shape& shape, float factor) {
    std::vector<Vec2> vertices;
    for (int i = 0; i < shape.vertex_count(); ++i) vertices.push_back(factor * shape.vertex(i));
    return Shape::from_raw(vertices, factor * shape.radius());
}

Pose scaled(const Pose& pose, double factor) { return {factor * pose.position, pose.rotation}; }

Rotation quarter_turned(Rotation q) { return {-q.s, q.c}; }
Pose quarter_turned(const Pose& pose) { return {perp(pose.position), quarter_turned(pose.rotation)}; }

// Positions on a grid of 2^-20 up to 8: shifting them by multiples of it up to 2^30 is exact.
Pose on_grid(const Pose& pose) {
    return {{std::nearbyint(pose.position.x * 0x1p20) * 0x1p-20, std::nearbyint(pose.position.y * 0x1p20) * 0x1p-20},
            pose.rotation};
}

void check_same_numbers(const DistanceResult& one, const DistanceResult& other) {
    CHECK(one.distance == other.distance);
    CHECK(one.lower == other.lower);
    CHECK(one.upper == other.upper);
    CHECK(one.status == other.status);
}

Pair rounded_pair(PairSource& source, int sample) {
    Pair pair = sample % 2 ? source.near_pair() : source.pair();
    if (sample % 4 > 1) pair.a = Shape::from_raw(std::vector<Vec2>{pair.a.vertex(0)}, 0.25f);
    return pair;
}

}  // namespace

TEST_CASE("swapping the shapes negates the normal and exchanges the points, bit for bit") {
    PairSource source(61);
    for (int sample = 0; sample < kPairs; ++sample) {
        const Pair pair = rounded_pair(source, sample);
        const DistanceResult one = measure(pair), other = measure(swapped(pair));
        check_same_numbers(one, other);
        CHECK(one.iterations == other.iterations);
        // Random pairs have one closest or deepest feature.
        CHECK(one.normal == -other.normal);
        CHECK(one.point_a == other.point_b);
        CHECK(one.point_b == other.point_a);
    }
}

TEST_CASE("an exact translation moves nothing but the points") {
    PairSource source(62);
    for (int sample = 0; sample < kPairs; ++sample) {
        Pair pair = rounded_pair(source, sample);
        pair.pose_a = on_grid(pair.pose_a);
        pair.pose_b = on_grid(pair.pose_b);
        Pair moved = pair;
        const DVec2 shift(source.below(1 << 30) - (1 << 29), source.below(1 << 30) - (1 << 29));
        moved.pose_a.position += shift;
        moved.pose_b.position += shift;
        const DistanceResult one = measure(pair), other = measure(moved);
        check_same_numbers(one, other);
        CHECK(one.normal == other.normal);
    }
}

TEST_CASE("scaling by a power of two scales every length, bit for bit") {
    PairSource source(63);
    for (int sample = 0; sample < kPairs; ++sample) {
        const Pair pair = rounded_pair(source, sample);
        const double factor = std::ldexp(1.0, source.below(161) - 80);
        const float f = static_cast<float>(factor);
        const Pair grown{scaled(pair.a, f), scaled(pair.pose_a, factor), scaled(pair.b, f),
                         scaled(pair.pose_b, factor)};
        const DistanceResult one = measure(pair), other = measure(grown);
        CHECK(factor * one.distance == other.distance);
        CHECK(factor * one.lower == other.lower);
        CHECK(factor * one.upper == other.upper);
        CHECK(one.status == other.status);
        CHECK(one.normal == other.normal);
        CHECK(factor * one.point_a == other.point_a);
    }
}

TEST_CASE("quarter turns of the world turn the answer exactly") {
    PairSource source(64);
    for (int sample = 0; sample < kPairs; ++sample) {
        const Pair pair = rounded_pair(source, sample);
        const Pair turned{pair.a, quarter_turned(pair.pose_a), pair.b, quarter_turned(pair.pose_b)};
        const DistanceResult one = measure(pair), other = measure(turned);
        check_same_numbers(one, other);
        CHECK(perp(one.normal) == other.normal);
        CHECK(perp(one.point_a) == other.point_a);
        CHECK(perp(one.point_b) == other.point_b);
    }
}

TEST_CASE("a query with a fitting, stale, random or out-of-range cache has the numbers of one without") {
    PairSource source(65);
    int fewer = 0;
    for (int sample = 0; sample < kPairs; ++sample) {
        const Pair pair = rounded_pair(source, sample);
        const DistanceResult cold = measure(pair);
        SimplexCache cache;
        for (VertexPair& index : cache.pairs) {
            index.a =
                static_cast<std::uint16_t>(source.coin() ? source.below(pair.a.vertex_count()) : source.below(65536));
            index.b =
                static_cast<std::uint16_t>(source.coin() ? source.below(pair.b.vertex_count()) : source.below(65536));
        }
        cache.count = static_cast<std::uint8_t>(source.coin() ? source.below(4) : source.below(256));
        const DistanceResult wrong = measure(pair, &cache);
        check_same_numbers(cold, wrong);
        const DistanceResult warm = measure(pair, &cache);
        check_same_numbers(cold, warm);
        CHECK(warm.normal == cold.normal);
        CHECK(warm.point_a == cold.point_a);
        CHECK(warm.point_b == cold.point_b);
        CHECK(warm.iterations <= cold.iterations);
        fewer += warm.iterations < cold.iterations;
        // The pair moves on: the cache is stale by a little.
        Pair moved = pair;
        moved.pose_b.position += DVec2(source.uniform(-0.1, 0.1), source.uniform(-0.1, 0.1));
        check_same_numbers(measure(moved), measure(moved, &cache));
    }
    CHECK(fewer > kPairs / 2);
}

TEST_CASE("where the closest pair is not unique, warm and cold give one status and overlapping bounds") {
    PairSource source(66);
    for (int sample = 0; sample < kPairs; ++sample) {
        const Shape box = make_box({1, 1});
        const Pose pose = source.pose(1);
        Pair pair{box, pose, box, {pose.position + DVec2(source.uniform(-2, 2), source.uniform(-2, 2)), pose.rotation}};
        const DistanceResult cold = measure(pair);
        SimplexCache cache;
        for (VertexPair& index : cache.pairs)
            index = {static_cast<std::uint16_t>(source.below(4)), static_cast<std::uint16_t>(source.below(4))};
        cache.count = static_cast<std::uint8_t>(source.below(4));
        for (int again = 0; again < 2; ++again) {
            const DistanceResult warm = measure(pair, &cache);
            CHECK(warm.status == cold.status);
            CHECK(std::max(warm.lower, cold.lower) <= std::min(warm.upper, cold.upper));
        }
    }
}

TEST_CASE("the loop by any subalgorithm, traced or not, and the query give the same bits") {
    PairSource source(67);
    int by_faces = 0, separated = 0;
    for (int sample = 0; sample < kPairs; ++sample) {
        const Pair pair = rounded_pair(source, sample);
        const auto by = static_cast<SubAlgorithm>(sample % 3);
        const DistanceResult one = measure(pair), loop = gjk_distance(pair.a, pair.pose_a, pair.b, pair.pose_b, by);
        const DistanceTrace trace = trace_distance(pair.a, pair.pose_a, pair.b, pair.pose_b, by);
        for (const DistanceResult& other : {loop, trace.result}) {
            check_same_numbers(one, other);
            CHECK(one.normal == other.normal);
            CHECK(one.point_a == other.point_a);
            CHECK(one.point_b == other.point_b);
            CHECK(one.certificate.direction == other.certificate.direction);
            CHECK(trace.steps.size() + 1 == other.iterations);
        }
        by_faces += std::max(pair.a.vertex_count(), pair.b.vertex_count()) <= Shape::kInlineVertices;
        separated += one.status == DistanceStatus::separated;
    }
    CHECK(by_faces > 0.5 * kPairs);
    CHECK(separated > 0.3 * kPairs);
    CHECK(separated < 0.8 * kPairs);
}

TEST_CASE("a cache warms the loop by any subalgorithm") {
    PairSource source(68);
    int fewer = 0;
    for (int sample = 0; sample < kPairs; ++sample) {
        const Pair pair = rounded_pair(source, sample);
        const auto by = static_cast<SubAlgorithm>(sample % 3);
        SimplexCache cache;
        const DistanceResult cold = gjk_distance(pair.a, pair.pose_a, pair.b, pair.pose_b, by, &cache);
        const DistanceResult warm = gjk_distance(pair.a, pair.pose_a, pair.b, pair.pose_b, by, &cache);
        check_same_numbers(cold, warm);
        CHECK(warm.normal == cold.normal);
        CHECK(warm.iterations <= cold.iterations);
        fewer += warm.iterations < cold.iterations;
    }
    CHECK(fewer > kPairs / 2);
}
