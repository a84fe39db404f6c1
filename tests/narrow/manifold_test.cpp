#include "tumble/manifold.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <random>
#include <set>

#include "narrow/manifold/clip.hpp"
#include "support/moving_pairs.hpp"
#include "support/near.hpp"
#include "support/random_pairs.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

constexpr double kSpeculative = 0.02;

Manifold collide_cold(const Shape& a, const Pose& pa, const Shape& b, const Pose& pb,
                      double speculative = kSpeculative) {
    SimplexCache cache;
    return collide(a, pa, b, pb, speculative, cache);
}

Pose at(double x, double y, double degrees = 0.0) { return {{x, y}, make_rotation_degrees(degrees)}; }

void check_near(Vec2 found, double x, double y) {
    CHECK(std::abs(found.x - x) < 1e-6);
    CHECK(std::abs(found.y - y) < 1e-6);
}

}  // namespace

TEST_CASE("two circles touch in one point on the line of their centers") {
    // Centers 3-4-5 apart, radii 2 and 2.99: gap 0.01, the middle of the gap 2.005 from A along (0.6, 0.8).
    const Manifold m = collide_cold(make_circle(2), at(10, 20), make_circle(2.99f), at(13, 24));
    REQUIRE(m.point_count == 1);
    check_near(m.normal, 0.6, 0.8);
    CHECK(near(m.points[0].separation, 0.01, absolute(1e-7)));
    check_near(m.points[0].anchor_a, 2.005 * 0.6, 2.005 * 0.8);
    check_near(m.points[0].anchor_b, -2.995 * 0.6, -2.995 * 0.8);
}

TEST_CASE("a box on the ground touches in its two lower corners") {
    // The ground's top is y = 0; the unit box's bottom is at 0.49 - 0.5 = -0.01.
    for (const bool ground_first : {true, false}) {
        const Shape ground = make_box({40, 1}), box = make_box({1, 1});
        const Manifold m = ground_first ? collide_cold(ground, at(0, -0.5), box, at(3, 0.49))
                                        : collide_cold(box, at(3, 0.49), ground, at(0, -0.5));
        REQUIRE(m.point_count == 2);
        check_near(m.normal, 0, ground_first ? 1 : -1);
        std::multiset<double> xs;
        for (const ManifoldPoint& point : m.points) {
            CHECK(near(point.separation, -0.01, kFloat));
            const Vec2 from_box = ground_first ? point.anchor_b : point.anchor_a;
            const Vec2 from_ground = ground_first ? point.anchor_a : point.anchor_b;
            CHECK(near(from_box.y, -0.495, kFloat));  // between the surfaces at y = -0.005
            CHECK(near(from_ground.y, 0.495, kFloat));
            CHECK(near(from_ground.x, 3 + from_box.x, kFloat));
            xs.insert(from_box.x);
        }
        CHECK(near(*xs.begin(), -0.5, kFloat));
        CHECK(near(*xs.rbegin(), 0.5, kFloat));
        CHECK(m.points[0].feature != m.points[1].feature);
    }
}

TEST_CASE("an overhanging box is clipped at the edge below it") {
    // B covers x from 0.3 to 1.3 above A's top from -0.5 to 0.5: contact between 0.3 and 0.5.
    const Manifold m = collide_cold(make_box({1, 1}), at(0, 0), make_box({1, 1}), at(0.8, 1.0));
    REQUIRE(m.point_count == 2);
    check_near(m.normal, 0, 1);
    CHECK(near(std::min(m.points[0].anchor_a.x, m.points[1].anchor_a.x), 0.3, kFloat));
    CHECK(near(std::max(m.points[0].anchor_a.x, m.points[1].anchor_a.x), 0.5, kFloat));
}

TEST_CASE("a tilted box touches in one corner, the other is beyond the speculative distance") {
    // Tilted by 45 degrees: the lowest corner is sqrt(1/2) below the center.
    const Manifold m = collide_cold(make_box({40, 1}), at(0, -0.5), make_box({1, 1}), at(0, std::sqrt(0.5), 45));
    REQUIRE(m.point_count == 1);
    check_near(m.normal, 0, 1);
    CHECK(std::abs(m.points[0].separation) < 1e-6);
    check_near(m.points[0].anchor_b, 0, -std::sqrt(0.5));
}

TEST_CASE("equal boxes exactly on top of each other touch in two points, rounded or not") {
    for (const float radius : {0.0f, 0.1f}) {
        for (const double gap : {-0.005, 0.0, 0.005}) {
            const Shape box = make_box({1, 1}, radius);
            const Manifold m = collide_cold(box, at(0, 0), box, at(0, 1 + gap));
            REQUIRE(m.point_count == 2);
            check_near(m.normal, 0, 1);
            CHECK(near(m.points[0].separation, gap, absolute(1e-7)));
        }
    }
}

TEST_CASE("a deep overlap is left through the nearest face") {
    // B's center is 0.9 above A's: 0.1 deep upwards, sideways 0.8.
    const Manifold m = collide_cold(make_box({1, 1}), at(0, 0), make_box({1, 1}), at(0.2, 0.9));
    REQUIRE(m.point_count == 2);
    check_near(m.normal, 0, 1);
    CHECK(near(m.points[0].separation, -0.1, kFloat));
}

TEST_CASE("around the corner of a rounded box the normal turns smoothly") {
    const Shape box = make_box({2, 2}, 0.5f), ball = make_circle(0.25f);
    for (int degrees = 1; degrees < 90; ++degrees) {
        const SinCos direction = sin_cos(degrees * kPi / 180.0);
        const Manifold m =
            collide_cold(box, at(0, 0), ball, at(0.5 + 0.74 * direction.cos, 0.5 + 0.74 * direction.sin));
        REQUIRE(m.point_count == 1);
        check_near(m.normal, direction.cos, direction.sin);
        CHECK(near(m.points[0].separation, -0.01, kFloat));
    }
}

TEST_CASE("parallel capsules touch along their overlap, crossed ones in a point") {
    const Shape capsule = make_capsule({-1, 0}, {1, 0}, 0.25f);
    const Manifold along = collide_cold(capsule, at(0, 0), capsule, at(0.5, 0.49));
    REQUIRE(along.point_count == 2);
    check_near(along.normal, 0, 1);
    CHECK(near(along.points[0].separation, -0.01, kFloat));
    CHECK(near(std::abs(along.points[0].anchor_a.x - along.points[1].anchor_a.x), 1.5, kFloat));
    const Manifold crossed = collide_cold(capsule, at(0, 0), capsule, at(0, 1.49, 90));
    REQUIRE(crossed.point_count == 1);
    check_near(crossed.normal, 0, 1);
    check_near(crossed.points[0].anchor_b, 0, -1.245);
}

TEST_CASE("a ball rests on a segment from either side") {
    const Shape ball = make_circle(0.5f), segment = make_segment({-2, 0}, {2, 0});
    for (const double side : {1.0, -1.0}) {
        const Manifold m = collide_cold(segment, at(0, 0), ball, at(0.3, 0.5 * side));
        REQUIRE(m.point_count == 1);
        check_near(m.normal, 0, side);
        CHECK(std::abs(m.points[0].separation) < 1e-7);
        check_near(m.points[0].anchor_a, 0.3, 0);
    }
}

TEST_CASE("features stay while a box slides and rocks, and the reference edge does not flicker") {
    const Shape ground = make_box({10, 1}), box = make_box({1, 1});
    SimplexCache cache;
    std::set<std::set<std::uint32_t>> features;
    for (int step = 0; step < 200; ++step) {
        const double rock = (step % 2 ? 1 : -1) * 0.01;  // degrees: 1.7e-4 rad lifts a corner by 0.17 mm
        const Manifold m = collide(ground, at(0, -0.5), box, at(0.01 * step, 0.499, rock), kSpeculative, cache);
        REQUIRE(m.point_count == 2);
        CHECK(m.points[0].anchor_a.x > m.points[1].anchor_a.x);  // along A's upper edge, which runs to the left
        features.insert({m.points[0].feature, m.points[1].feature});
        CHECK(cache.reference_side == Side::a);
    }
    CHECK(features.size() == 1);
}

TEST_CASE("nothing is reported beyond the speculative distance or for what is invalid") {
    const Shape box = make_box({1, 1});
    CHECK(collide_cold(box, at(0, 0), box, at(0, 1.021)).point_count == 0);
    CHECK(collide_cold(box, at(0, 0), box, at(0, 1.019)).point_count == 2);
    CHECK(collide_cold(box, at(0, 0), Shape{}, at(0, 0)).point_count == 0);
    CHECK(collide_cold(box, at(NAN, 0), box, at(0, 0)).point_count == 0);
}

TEST_CASE("random manifolds: the deepest point agrees with the signed distance, and lies between the surfaces") {
    std::mt19937_64 random(41);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    int touching = 0, two_points = 0;
    for (int sample = 0; sample < 20000; ++sample) {
        const auto polygon = [&](int count) {
            std::vector<Vec2> points;
            for (int i = 0; i < count; ++i)
                points.push_back({static_cast<float>(unit(random)), static_cast<float>(unit(random))});
            return make_polygon(points, sample % 3 ? 0.0f : 0.1f);
        };
        const Shape a = polygon(1 + sample % 9), b = polygon(1 + sample / 9 % 12);
        const Pose pa{{unit(random), unit(random)}, make_rotation_degrees(180 * unit(random))};
        Pose pb{{2 * unit(random), 2 * unit(random)}, make_rotation_degrees(180 * unit(random))};
        const DistanceResult first = distance(a, pa, b, pb);
        pb.position += (0.02 * unit(random) - first.distance) * first.normal;
        const DistanceResult sd = distance(a, pa, b, pb);
        const Manifold m = collide_cold(a, pa, b, pb);
        if (sd.distance > kSpeculative) {
            CHECK(m.point_count == 0);
            continue;
        }
        REQUIRE(m.point_count > 0);
        ++touching;
        two_points += m.point_count == 2;
        double deepest = 1e9;
        for (int i = 0; i < m.point_count; ++i) {
            const ManifoldPoint& point = m.points[i];
            deepest = std::min<double>(deepest, point.separation);
            CHECK(point.separation <= static_cast<float>(kSpeculative));
            const DVec2 on_a = pa.position + DVec2(point.anchor_a), on_b = pb.position + DVec2(point.anchor_b);
            CHECK(length(on_a - on_b) < 1e-5);  // anchors are floats of size 4
        }
        // For a corner against a corner the manifold uses a face, clipped at its end: a tolerance of a fiftieth of the
        // speculative distance to either side, and 1e-6 m for floats.
        CHECK(std::abs(deepest - sd.distance) < 0.02 * kSpeculative + 1e-6);
    }
    CHECK(touching > 10000);
    CHECK(two_points > touching / 20);
    CHECK(two_points < touching);
}

TEST_CASE("swapping the shapes gives the same contact seen from the other one") {
    tumble_test::PairSource source(42);
    int compared = 0, two_points = 0;
    for (int sample = 0; sample < 20000; ++sample) {
        const tumble_test::Pair pair = source.near_pair();
        const Manifold found = collide_cold(pair.a, pair.pose_a, pair.b, pair.pose_b);
        const Manifold swapped = collide_cold(pair.b, pair.pose_b, pair.a, pair.pose_a);
        INFO("sample ", sample);
        REQUIRE(found.point_count == swapped.point_count);
        if (found.point_count == 0) continue;
        ++compared;
        two_points += found.point_count == 2;
        // The same features, and with them the same arithmetic but for the rounding to float: of anchors of up to 6 m.
        check_near(found.normal + swapped.normal, 0, 0);
        for (int i = 0; i < found.point_count; ++i) {
            const ManifoldPoint& point = found.points[i];
            const ManifoldPoint& other = swapped.points[found.point_count - 1 - i];
            CHECK(point.feature == (other.feature >> 16 | other.feature << 16));
            CHECK(std::abs(point.separation - other.separation) < 1e-6f);
            check_near(point.anchor_a - other.anchor_b, 0, 0);
            check_near(point.anchor_b - other.anchor_a, 0, 0);
        }
    }
    CHECK(compared > 10000);
    CHECK(two_points > 500);
}

TEST_CASE(
    "a manifold at a scale of 2^k is the manifold scaled, bit for bit, from a nanometre to a million kilometres") {
    tumble_test::PairSource source(43);
    int compared = 0;
    for (int sample = 0; sample < 20000; ++sample) {
        const tumble_test::Pair pair = source.near_pair();
        const int exponent = source.below(61) - 30;
        const auto scaled = [exponent](const Pose& pose) {
            return Pose{{std::ldexp(pose.position.x, exponent), std::ldexp(pose.position.y, exponent)}, pose.rotation};
        };
        const Manifold found = collide_cold(pair.a, pair.pose_a, pair.b, pair.pose_b);
        const Manifold other = collide_cold(tumble_test::scaled(pair.a, exponent), scaled(pair.pose_a),
                                            tumble_test::scaled(pair.b, exponent), scaled(pair.pose_b),
                                            std::ldexp(kSpeculative, exponent));
        INFO("sample ", sample, " exponent ", exponent);
        REQUIRE(found.point_count == other.point_count);
        REQUIRE((found.normal == other.normal || found.point_count == 0));
        const auto is_scaled = [exponent](Vec2 from, Vec2 to) {
            return std::ldexp(from.x, exponent) == to.x && std::ldexp(from.y, exponent) == to.y;
        };
        for (int i = 0; i < found.point_count; ++i) {
            ++compared;
            REQUIRE(found.points[i].feature == other.points[i].feature);
            REQUIRE(std::ldexp(found.points[i].separation, exponent) == other.points[i].separation);
            REQUIRE(is_scaled(found.points[i].anchor_a, other.points[i].anchor_a));
            REQUIRE(is_scaled(found.points[i].anchor_b, other.points[i].anchor_b));
        }
    }
    CHECK(compared > 10000);
}

TEST_CASE("a normal that rounding turned against its edge gives way to the normal of the edge") {
    // Two boxes of 2 m, B 0.5 m above A: their faces are 0.5 m apart over the whole edge.
    const Shape box = make_box({2.0f, 2.0f});
    const CorePair pair = make_core_pair(box, at(0, 0), box, at(0, 2.5));
    int top = 0;  // the edge of A from its upper right to its upper left corner
    while (!(pair.a.point(top).y > 0.0 && pair.a.point(pair.a.next(top)).y > 0.0)) ++top;
    int lower = 0;
    while (pair.b.point(lower).y > 0.0) ++lower;
    for (const DVec2 normal : {DVec2{0.0, 1.0}, DVec2{0.0, -1.0}}) {
        const ClippedEdge clipped = clip({pair.a, pair.b, pair.offset, top, lower, normal, 1e-4});
        CHECK(clipped.normal == DVec2{0.0, 1.0});
        REQUIRE(clipped.count == 2);
        for (const ClippedPoint& point : clipped.points) CHECK(point.separation == 0.5);
    }
}
