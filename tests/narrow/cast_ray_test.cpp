// Rays against the general cast of a point, which is checked against an independent distance, and by hand.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "support/brute_distance.hpp"
#include "support/moving_pairs.hpp"
#include "support/near.hpp"
#include "tumble/cast.hpp"

using namespace tumble;
using namespace tumble::test;
using tumble_test::Random;
using tumble_test::Real;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

CastResult cast_point(const Shape& shape, const Pose& pose, DVec2 origin, DVec2 translation) {
    return cast_shape(shape, pose, make_circle(0), {origin, {}}, translation);
}

}  // namespace

TEST_CASE("a ray finds what the cast of a point finds, and stops on the surface") {
    int hits = 0;
    const std::uint64_t count = tumble_test::pair_count();
    for (std::uint64_t index = 0; index < count; ++index) {
        Random random(1, index);
        const Shape shape = tumble_test::random_shape(random, tumble_test::random_kind(random), 1.0);
        const Pose pose{random.point(random.chance(0.2) ? 1e4 : 1.0), random.rotation()};
        const DVec2 origin = pose.position + random.point(3.0);
        const DVec2 motion = random.uniform(0.3, 4.0) * (pose.position + random.point(0.7) - origin);
        const CastResult ray = cast_ray(shape, pose, origin, motion), cast = cast_point(shape, pose, origin, motion);
        const Real scale = shape.core_radius() + shape.radius() + length(origin - pose.position);
        const Real error = 16 * 0x1p-53L * scale;
        INFO("pair ", index);
        const bool is_graze = ray.status != cast.status;
        if (is_graze) {  // one of them may hit a vertex that the line misses by less than the error bound
            const CastResult& hit = ray.status == CastStatus::hit ? ray : cast;
            REQUIRE(hit.upper >= 1.0);
            continue;
        }
        if (ray.status != CastStatus::hit) continue;
        ++hits;
        REQUIRE(ray.lower <= cast.upper);
        REQUIRE(cast.lower <= ray.upper);
        REQUIRE(std::abs(length(ray.normal) - 1.0) < 1e-15);
        const Shape point = make_circle(0);
        const DVec2 end = origin + ray.fraction * motion;
        const Real rounding = 0x1p-52L * (std::abs(end.x) + std::abs(end.y) + length(motion));
        REQUIRE(std::abs(tumble_test::brute_distance(shape, pose, point, {ray.point, {}})) <= 4 * error + rounding);
        const Real rate = -dot(ray.normal, motion) / length(motion);
        REQUIRE(length(end - ray.point) <= static_cast<double>((4 * error + rounding) / rate));
    }
    CHECK(hits > 0.3 * static_cast<double>(count));
    CHECK(hits < 0.9 * static_cast<double>(count));
}

TEST_CASE("rays hit a box and a ball at hand-computed fractions") {
    const Shape box = make_box({2, 4}), ball = make_circle(5);
    const CastResult wall = cast_ray(box, {{10, 0}, make_rotation_degrees(90)}, {0, 0.5}, {16, 0});
    CHECK(wall.status == CastStatus::hit);
    CHECK(wall.fraction == 0.5);  // the turned box begins at x = 8
    CHECK(wall.normal == DVec2{-1, 0});
    CHECK(wall.point == DVec2{8, 0.5});
    const CastResult curve = cast_ray(ball, {}, {-12, 3}, {16, 0});
    CHECK(curve.fraction == 0.5);  // at (-4, 3)
    CHECK(near(curve.normal.x, -0.8, kDouble));
    CHECK(near(curve.normal.y, 0.6, kDouble));
    CHECK(cast_ray(ball, {}, {-12, 5.0000001}, {16, 0}).status == CastStatus::miss);
    CHECK(cast_ray(ball, {}, {-12, 3}, {7.9999, 0}).status == CastStatus::miss);
    CHECK(cast_ray(ball, {}, {-12, 3}, {-16, 0}).status == CastStatus::miss);
    CHECK(cast_ray(box, {}, {-3, 5}, {6, 0}).status == CastStatus::miss);
    CHECK(cast_ray(box, {}, {-3, 1}, {-6, 0}).status == CastStatus::miss);
}

TEST_CASE("a ray from inside overlaps, one that leaves a surface misses, one that enters there hits at 0") {
    for (const Shape& shape :
         {make_box({2, 2}), make_circle(1), make_capsule({-0.5f, 0}, {0.5f, 0}, 0.5f), make_box({2, 2}, 0.1f)}) {
        CHECK(cast_ray(shape, {}, {0.25, 0.125}, {5, 0}).status == CastStatus::overlapping);
        CHECK(cast_ray(shape, {}, {1, 0}, {5, 1}).status == CastStatus::miss);
        CHECK(cast_ray(shape, {}, {1, 0}, {-5, 1}).status == CastStatus::hit);
        CHECK(cast_ray(shape, {}, {1, 0}, {-5, 1}).fraction <= 1e-8);  // 0, or the rounding of a radius to float
        CHECK(cast_ray(shape, {}, {1.0000001, 0}, {5, 1}).status == CastStatus::miss);
        CHECK(cast_ray(shape, {}, {1, 0}, {0, 0}).status == CastStatus::miss);
    }
}

TEST_CASE("single ulps to either side do not make rays at a vertex miss, nor inward ones rays along an edge") {
    const Shape box = make_box({2, 2});
    for (int ulps = -20; ulps <= 20; ++ulps) {
        double y = 1.0;
        for (int i = 0; i < std::abs(ulps); ++i) y = std::nextafter(y, ulps < 0 ? -kInfinity : kInfinity);
        const CastResult along = cast_ray(box, {}, {-5, y}, {8, 0});
        const CastResult corner = cast_ray(box, {}, {-1 - 4, y + 4}, {8, -8});
        if (ulps <= 0) CHECK(near(along.fraction, 0.5, kDouble));
        CHECK(corner.status == CastStatus::hit);
        CHECK(near(corner.fraction, 0.5, kDouble));
    }
}

TEST_CASE("a segment is hit from both sides") {
    const Shape post = make_segment({0, -1}, {0, 1});
    CHECK(cast_ray(post, {}, {-3, 0.5}, {6, 0}).fraction == 0.5);
    CHECK(cast_ray(post, {}, {-3, 0.5}, {6, 0}).normal == DVec2{-1, 0});
    CHECK(cast_ray(post, {}, {3, 0.5}, {-6, 0}).fraction == 0.5);
    CHECK(cast_ray(post, {}, {3, 0.5}, {-6, 0}).normal == DVec2{1, 0});
    CHECK(cast_ray(post, {}, {0, 4}, {0, -6}).fraction == 0.5);
    CHECK(cast_ray(post, {}, {3, 1.5}, {-6, 0}).status == CastStatus::miss);
}

TEST_CASE("a segment behind the start is not hit after it, also if it is nearer than rounding") {
    int near_starts = 0;
    for (std::uint64_t index = 0; index < 100000; ++index) {
        Random random(2, index);
        const auto offset = [&] { return std::exp2(random.uniform(-60.0, 0.0)) * random.point(1.0); };
        const Shape segment = make_segment(to_float(random.point(1.0)), to_float(random.point(1.0)));
        const DVec2 a(segment.vertex(0)), along = DVec2(segment.vertex(1)) - a;
        const DVec2 origin = a + random.uniform(-1.0, 2.0) * along + offset();
        const DVec2 motion = a + random.uniform(-1.0, 2.0) * along + offset() - origin;
        const CastResult ray = cast_ray(segment, {}, origin, motion);
        if (ray.status != CastStatus::hit || ray.lower < 0.0) continue;
        // The lines cross at a + part * along and at origin + fraction * motion. A hit elsewhere is a graze of an end.
        const Real x = Real(a.x) - origin.x, y = Real(a.y) - origin.y;
        const Real rate = Real(motion.x) * along.y - Real(motion.y) * along.x;
        const Real part = (x * motion.y - y * motion.x) / rate, fraction = (x * along.y - y * along.x) / rate;
        if (!(part >= 0 && part <= 1)) continue;
        INFO("ray ", index);
        REQUIRE(fraction >= 0);
        near_starts += ray.lower < 1e-6;
    }
    CHECK(near_starts > 100);
}

TEST_CASE("scaling the rotation away from 1 scales the shape, as for distances") {
    // q = (3, 4) turns and stretches by 5: the box of side 2 has its face at 5 from the centre.
    const Pose pose{{}, {3, 4}};
    const CastResult ray = cast_ray(make_box({2, 2}), pose, {-12, -16}, {12, 16});
    CHECK(ray.status == CastStatus::hit);
    CHECK(near(ray.fraction, 0.75, kDouble));
    CHECK(near(ray.normal.x, -0.6, kDouble));
    CHECK(near(ray.normal.y, -0.8, kDouble));
}

TEST_CASE("a ray that is not finite is invalid") {
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), kInfinity, 1e300}) {
        CHECK(cast_ray(make_circle(1), {}, {bad, 0}, {1, 0}).status == CastStatus::invalid);
        CHECK(cast_ray(make_circle(1), {}, {-5, 0}, {bad, 0}).status == CastStatus::invalid);
    }
    CHECK(cast_ray(Shape{}, {}, {-5, 0}, {1, 0}).status == CastStatus::invalid);
}
