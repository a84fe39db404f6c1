// What holds within the stated bounds: inflation, Lipschitz continuity, subsets, convexity, witness points.
#include <doctest/doctest.h>

#include <array>

#include "support/brute_distance.hpp"
#include "support/near.hpp"
#include "support/random_pairs.hpp"

using namespace tumble;
using namespace tumble::test;
using namespace tumble_test;

namespace {

constexpr int kPairs = 10000;

Shape with_radius(const Shape& shape, float radius) {
    std::vector<Vec2> vertices;
    for (int i = 0; i < shape.vertex_count(); ++i) vertices.push_back(shape.vertex(i));
    return Shape::from_raw(vertices, radius);
}

Shape without_vertex(const Shape& shape, int dropped) {
    std::vector<Vec2> vertices;
    for (int i = 0; i < shape.vertex_count(); ++i)
        if (i != dropped) vertices.push_back(shape.vertex(i));
    return Shape::from_raw(vertices, shape.radius());
}

// The bound on either answer is 16 u S, so two of them differ by at most 32 u S and what the inputs themselves explain.
double bound_of_two(const Pair& pair) { return 34.0 * rounding_of(pair); }

double distance_from_shape(DVec2 point, const Shape& shape, const Pose& pose) {
    const Shape spot = Shape::from_raw(std::array<Vec2, 1>{}, 0);
    return static_cast<double>(brute_distance(spot, {point, {}}, shape, pose));
}

}  // namespace

TEST_CASE("a radius of r brings the shapes nearer by r, through contact and overlap") {
    PairSource source(71);
    for (int sample = 0; sample < kPairs; ++sample) {
        Pair pair = source.near_pair();
        const double cores = measure(pair).distance;
        for (const float radius : {0.125f, 1.0f, 64.0f}) {
            pair.b = with_radius(pair.b, radius);
            CHECK(measure(pair).distance == cores - radius);
        }
    }
}

TEST_CASE("the distance changes by no more than a shift, and by all of a shift along the normal of separated shapes") {
    PairSource source(72);
    for (int sample = 0; sample < kPairs; ++sample) {
        Pair pair = sample % 2 ? source.near_pair() : source.pair();
        const DistanceResult before = measure(pair);
        const DVec2 shift(source.uniform(-0.5, 0.5), source.uniform(-0.5, 0.5));
        Pair moved = pair;
        moved.pose_b.position += shift;
        const DVec2 moved_by = moved.pose_b.position - pair.pose_b.position;
        CHECK(std::abs(measure(moved).distance - before.distance) <= length(moved_by) + bound_of_two(pair));
        // A separating direction bounds the distance from below after any shift.
        if (before.distance > 0.0)
            CHECK(measure(moved).distance >= before.distance + dot(moved_by, before.normal) - bound_of_two(pair));
        Pair leaving = pair;
        leaving.pose_b.position += before.normal;
        if (before.distance > 0.0) CHECK(near(measure(leaving).distance, before.distance + 1.0, relative(1e-14)));
    }
}

TEST_CASE("along a line the core distance of separated shapes is convex at its middle") {
    PairSource source(73);
    int separated = 0;
    for (int sample = 0; sample < kPairs; ++sample) {
        Pair from = source.pair(), middle = from, to = from;
        const DVec2 half(source.uniform(-1, 1), source.uniform(-1, 1));
        middle.pose_b.position += half;
        to.pose_b.position += 2.0 * half;
        const double at_ends = 0.5 * (measure(from).distance + measure(to).distance);
        const DistanceResult between = measure(middle);
        if (measure(from).distance <= 0.0 || measure(to).distance <= 0.0) continue;
        ++separated;
        CHECK(between.distance <= at_ends + bound_of_two(from));
    }
    CHECK(separated > kPairs / 3);
}

TEST_CASE("a subset is never nearer") {
    PairSource source(74);
    for (int sample = 0; sample < kPairs; ++sample) {
        Pair pair = sample % 2 ? source.near_pair() : source.pair();
        if (pair.a.vertex_count() < 2) continue;
        const double whole = measure(pair).distance;
        pair.a = without_vertex(pair.a, source.below(pair.a.vertex_count()));
        CHECK(measure(pair).distance >= whole - bound_of_two(pair));
    }
}

TEST_CASE("renumbering, doubled and inserted middle vertices change no status and no distance beyond the bounds") {
    PairSource source(75);
    for (int sample = 0; sample < kPairs; ++sample) {
        Pair pair = source.near_pair();
        const DistanceResult plain = measure(pair);
        std::vector<Vec2> vertices;
        const int count = pair.a.vertex_count(), start = source.below(count);
        for (int i = 0; i < count; ++i) {
            const Vec2 vertex = pair.a.vertex((start + i) % count);
            vertices.push_back(vertex);
            if (i == 0) vertices.push_back(vertex);
        }
        pair.a = Shape::from_raw(vertices, 0);
        const DistanceResult padded = measure(pair);
        CHECK(padded.status == plain.status);
        CHECK(std::max(padded.lower, plain.lower) <= std::min(padded.upper, plain.upper));
    }
}

TEST_CASE("witness points lie on the shapes and differ by the distance along the normal") {
    PairSource source(76);
    for (int sample = 0; sample < kPairs; ++sample) {
        Pair pair = sample % 2 ? source.near_pair() : source.pair();
        if (sample % 3 == 0) pair.a = with_radius(pair.a, 0.25f);
        const DistanceResult r = measure(pair);
        const double world = 0x1p-53 * (length(pair.pose_a.position) + length(pair.pose_b.position));
        const double rounding = bound_of_two(pair) + 16.0 * world;
        CHECK(std::abs(length(r.normal) - 1.0) < 4 * 0x1p-53);
        CHECK(length((r.point_b - r.point_a) - r.distance * r.normal) <= rounding);
        CHECK(distance_from_shape(r.point_a, pair.a, pair.pose_a) <= rounding);
        CHECK(distance_from_shape(r.point_b, pair.b, pair.pose_b) <= rounding);
        // On the surface of A, not inside: its signed distance from A is 0, not only at most 0.
        if (r.distance > 1e-9) CHECK(std::abs(distance_from_shape(r.point_a, pair.a, pair.pose_a)) <= rounding);
    }
}

TEST_CASE("mirrored shapes are as far apart") {
    PairSource source(77);
    const auto mirrored_shape = [](const Shape& shape) {
        std::vector<Vec2> vertices;
        for (int i = shape.vertex_count(); i-- > 0;) vertices.push_back({-shape.vertex(i).x, shape.vertex(i).y});
        return Shape::from_raw(vertices, shape.radius());
    };
    const auto mirrored_pose = [](const Pose& pose) {
        return Pose{{-pose.position.x, pose.position.y}, {pose.rotation.c, -pose.rotation.s}};
    };
    for (int sample = 0; sample < kPairs; ++sample) {
        const Pair pair = source.near_pair();
        const Pair mirror{mirrored_shape(pair.a), mirrored_pose(pair.pose_a), mirrored_shape(pair.b),
                          mirrored_pose(pair.pose_b)};
        const DistanceResult one = measure(pair), other = measure(mirror);
        CHECK(one.status == other.status);
        CHECK(std::max(one.lower, other.lower) <= std::min(one.upper, other.upper));
    }
}
