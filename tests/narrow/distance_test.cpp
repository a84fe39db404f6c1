// Hand-worked distances, degenerate cores and refused input.
#include "tumble/distance.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>

#include "support/near.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

Pose at(double x, double y, double degrees = 0.0) { return {{x, y}, make_rotation_degrees(degrees)}; }

void check_point(DVec2 found, double x, double y) {
    CHECK(near(found.x, x, absolute(1e-14)));
    CHECK(near(found.y, y, absolute(1e-14)));
}

void check_consistent(const DistanceResult& r) {
    CHECK(r.lower <= r.distance);
    CHECK(r.distance <= r.upper);
    CHECK(near(length(r.normal), 1.0, relative(1e-15)));
    CHECK(length((r.point_b - r.point_a) - r.distance * r.normal) <=
          1e-14 * (1.0 + length(r.point_a) + length(r.point_b)));
}

const Shape kBox = make_box({2, 2});

}  // namespace

TEST_CASE("the distance of two circles is that of their centers less the radii") {
    // 3-4-5: 5 - 1 - 2 = 2
    const DistanceResult r = distance(make_circle(1), at(10, 10), make_circle(2), at(13, 14));
    CHECK(r.distance == 2.0);
    CHECK(r.status == DistanceStatus::separated);
    check_point(r.normal, 0.6, 0.8);
    check_point(r.point_a, 10.6, 10.8);
    check_point(r.point_b, 11.8, 12.4);
    check_consistent(r);
}

TEST_CASE("the distance of a face from a vertex is measured along the normal of the face") {
    // B's left corner is sqrt(2) left of its center: 4 - sqrt(2) - 1.
    const DistanceResult r = distance(kBox, at(0, 0), kBox, at(4, 0.25, 45));
    // The rotation is rounded to float: its corner is at 2 c with c = float(sqrt(1/2)).
    const double corner = 2.0 * make_rotation_degrees(45).c;
    CHECK(near(r.distance, 3.0 - corner, kDouble));
    check_point(r.normal, 1, 0);
    check_point(r.point_a, 1, 0.25);
    check_point(r.point_b, 4.0 - corner, 0.25);
    CHECK(r.certificate.pair_count == 2);
    CHECK(r.certificate.pairs[0].b == r.certificate.pairs[1].b);
    check_consistent(r);
}

TEST_CASE("the normal between two corners is the direction between them") {
    // Corners (1, 1) and (4, 5): 3-4-5.
    const DistanceResult r = distance(kBox, at(0, 0), kBox, at(5, 6));
    CHECK(r.distance == 5.0);
    check_point(r.normal, 0.6, 0.8);
    check_point(r.point_a, 1, 1);
    check_point(r.point_b, 4, 5);
    CHECK(r.certificate.pair_count == 1);
    check_consistent(r);
}

TEST_CASE("the depth of overlapping boxes is that of the nearest face") {
    // B's center at (1.75, 0.5): 0.25 deep in x, 1.5 in y.
    const DistanceResult r = distance(kBox, at(0, 0), kBox, at(1.75, 0.5));
    CHECK(r.distance == -0.25);
    CHECK(r.status == DistanceStatus::overlapping);
    CHECK(r.certificate.cores_overlap);
    check_point(r.normal, 1, 0);
    CHECK(r.point_a.x == 1.0);
    CHECK(r.point_b.x == 0.75);
    check_consistent(r);
}

TEST_CASE("a radius is subtracted from the core distance, also inside") {
    // Core 1 x 1 grown by 0.5, and the same: cores 2 apart overlap by nothing until the radii touch.
    const Shape rounded = make_box({2, 2}, 0.5f);
    CHECK(distance(rounded, at(0, 0), rounded, at(2.5, 0)).distance == 0.5);
    CHECK(distance(rounded, at(0, 0), rounded, at(1.5, 0)).distance == -0.5);  // cores 0.5 apart
    CHECK(distance(rounded, at(0, 0), rounded, at(0.5, 0)).distance == -1.5);  // cores 0.5 deep
}

TEST_CASE("from a gap to an overlap the distance of two boxes changes by their displacement") {
    for (int step = -64; step <= 64; ++step) {
        const double gap = step / 64.0;
        const DistanceResult r = distance(kBox, at(0, 0), kBox, at(2 + gap, 0.25));
        CHECK(r.distance == gap);
        check_point(r.normal, 1, 0);
        CHECK(r.status == (step > 0   ? DistanceStatus::separated
                           : step < 0 ? DistanceStatus::overlapping
                                      : DistanceStatus::touching));
        check_consistent(r);
    }
}

TEST_CASE("coincident centers have a decided answer") {
    const DistanceResult points = distance(make_circle(0), at(3, 3), make_circle(0), at(3, 3));
    CHECK(points.distance == 0.0);
    CHECK(points.normal == DVec2{1, 0});
    CHECK(points.status == DistanceStatus::touching);
    const DistanceResult circles = distance(make_circle(1), at(3, 3), make_circle(2), at(3, 3));
    CHECK(circles.distance == -3.0);
    CHECK(circles.normal == DVec2{1, 0});
    CHECK(circles.status == DistanceStatus::overlapping);
    check_consistent(circles);
}

TEST_CASE("collinear capsules apart, end to end or inside each other have the distance of their cores less the radii") {
    const Shape capsule = make_capsule({-1, 0}, {1, 0}, 0.25f);
    for (const double degrees : {0.0, 30.0, 90.0, 137.0}) {
        const Pose origin = at(0, 0, degrees);
        const DVec2 along = rotate(origin.rotation, DVec2{1, 0});
        const auto shifted = [&](double by) { return Pose{by * along, origin.rotation}; };
        CHECK(near(distance(capsule, origin, capsule, shifted(3)).distance, 1.0 - 0.5, kFloat));
        CHECK(near(distance(capsule, origin, capsule, shifted(2)).distance, -0.5, kDouble));
        CHECK(near(distance(capsule, origin, capsule, shifted(0.5)).distance, -0.5, kDouble));
        const DistanceResult same = distance(capsule, origin, capsule, origin);
        CHECK(near(same.distance, -0.5, kDouble));
        CHECK(std::abs(dot(same.normal, along)) < 1e-6);  // sideways: the shortest displacement
        check_consistent(same);
    }
}

TEST_CASE("crossing segments are separated by the displacement to the nearer end") {
    // A from -1 to 1 on x, B from y = -0.25 to 4 at x = 0.5: lift B by 0.25.
    const DistanceResult r =
        distance(make_segment({-1, 0}, {1, 0}), at(0, 0), make_segment({0, -0.25f}, {0, 4}), at(0.5, 0));
    CHECK(r.distance == -0.25);
    check_point(r.normal, 0, 1);
    check_consistent(r);
}

TEST_CASE("a point on a segment touches it, and a point in a box is as deep as the nearest face") {
    const DistanceResult on = distance(make_circle(0), at(0.5, 0), make_segment({-1, 0}, {1, 0}), at(0, 0));
    CHECK(on.distance == 0.0);
    CHECK(on.normal.x == 0.0);
    CHECK(on.status == DistanceStatus::touching);
    const DistanceResult in = distance(kBox, at(0, 0), make_circle(0), at(0.75, 0.5));
    CHECK(in.distance == -0.25);
    check_point(in.normal, 1, 0);
}

TEST_CASE("polygons with duplicate or collinear vertices or without area have the distance of their hull") {
    const Shape spot = Shape::from_raw(std::array<Vec2, 4>{{{1, 2}, {1, 2}, {1, 2}, {1, 2}}}, 0);
    const Shape line = Shape::from_raw(std::array<Vec2, 3>{{{-1, 0}, {0, 0}, {1, 0}}}, 0);
    const Shape padded =
        Shape::from_raw(std::array<Vec2, 6>{{{-1, -1}, {0, -1}, {1, -1}, {1, -1}, {1, 1}, {-1, 1}}}, 0);
    CHECK(distance(spot, at(0, 0), spot, at(3, 4)).distance == 5.0);
    CHECK(distance(spot, at(0, 0), spot, at(0, 0)).distance == 0.0);
    CHECK(distance(line, at(0, 0), line, at(0.5, 0)).distance == 0.0);
    CHECK(distance(line, at(0, 0), line, at(2.5, 0)).distance == 0.5);
    CHECK(distance(line, at(0, 0), spot, at(-1, 0)).distance == 2.0);
    CHECK(distance(padded, at(0, 0), kBox, at(0.5, -1.75)).distance == -0.25);
    CHECK(distance(padded, at(0, 0), kBox, at(0.5, -2.5)).distance == 0.5);
}

TEST_CASE("the distance of vertices in any order is that of their hull") {
    const Shape box =
        Shape::from_raw(std::array<Vec2, 4>{{{-0.5f, -0.5f}, {0.5f, -0.5f}, {0.5f, 0.5f}, {-0.5f, 0.5f}}}, 0);
    const Shape clockwise =
        Shape::from_raw(std::array<Vec2, 4>{{{-0.5f, 0.5f}, {0.5f, 0.5f}, {0.5f, -0.5f}, {-0.5f, -0.5f}}}, 0);
    const Shape bow_tie =
        Shape::from_raw(std::array<Vec2, 4>{{{-0.5f, -0.5f}, {0.5f, 0.5f}, {0.5f, -0.5f}, {-0.5f, 0.5f}}}, 0);
    for (const Pose& pose : {at(2, 0.25, 10), at(-1, 1.25, 33), at(0.5, -1.25, 80)}) {
        const double expected = distance(box, at(0, 0), box, pose).distance;
        REQUIRE(expected > 0.0);
        for (const Shape& shape : {clockwise, bow_tie}) {
            CHECK(near(distance(shape, at(0, 0), box, pose).distance, expected, kDouble));
            CHECK(near(distance(box, at(0, 0), shape, pose).distance, expected, kDouble));
        }
    }
}

TEST_CASE("identical shapes at one pose are as deep as they are thin") {
    const DistanceResult r = distance(make_box({4, 1}), at(7, 8, 30), make_box({4, 1}), at(7, 8, 30));
    CHECK(near(r.distance, -1.0, kFloat));
    CHECK(r.status == DistanceStatus::overlapping);
}

TEST_CASE("a twelve-gon keeps its twelve vertices") {
    // Regular, circumradius 1, a vertex at (1, 0): the distance of its right corner from a wall at x = 1.5 is 0.5.
    std::vector<Vec2> points;
    for (int i = 0; i < 12; ++i) {
        const SinCos q = sin_cos(i * kPi / 6.0);
        points.push_back({static_cast<float>(q.cos), static_cast<float>(q.sin)});
    }
    CHECK(distance(make_polygon(points), at(0, 0), make_segment({1.5f, -9}, {1.5f, 9}), at(0, 0)).distance == 0.5);
}

TEST_CASE("input that is not finite, empty or negative is invalid, and every number of the result is NaN") {
    constexpr double inf = std::numeric_limits<double>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto is_refused = [](const Shape& a, const Pose& pa, const Shape& b, const Pose& pb) {
        for (const DistanceResult& r : {distance(a, pa, b, pb), distance(b, pb, a, pa)}) {
            if (r.status != DistanceStatus::invalid || !std::isnan(r.distance) || !std::isnan(r.lower) ||
                !std::isnan(r.upper) || !std::isnan(r.normal.x) || !std::isnan(r.point_a.y) || !std::isnan(r.point_b.x))
                return false;
        }
        return true;
    };
    const Pose origin = at(0, 0);
    CHECK(is_refused(Shape{}, origin, kBox, origin));
    CHECK(is_refused(Shape{}, origin, Shape{}, origin));
    CHECK(is_refused(kBox, at(nan, 0), kBox, origin));
    CHECK(is_refused(kBox, at(0, inf), kBox, origin));
    CHECK(is_refused(kBox, at(inf, 0), kBox, at(inf, 0)));
    CHECK(is_refused(kBox, {{0, 0}, {nan, 0}}, kBox, origin));
    CHECK(is_refused(kBox, {{0, 0}, {0, std::numeric_limits<float>::infinity()}}, kBox, origin));
    CHECK(is_refused(make_circle(1), {{0, 0}, {nan, 0}}, make_circle(1), origin));
    for (int bad = 0; bad < 3; ++bad) {
        std::array<Vec2, 3> vertices = {{{0, 0}, {1, 0}, {0, 1}}};
        vertices[static_cast<std::size_t>(bad)].y = nan;
        CHECK(is_refused(Shape::from_raw(vertices, 0), origin, kBox, origin));
    }
    CHECK(is_refused(Shape::from_raw(std::array<Vec2, 1>{}, -1.0f), origin, kBox, origin));
    CHECK(is_refused(Shape::from_raw(std::array<Vec2, 1>{}, nan), origin, kBox, origin));
    CHECK(is_refused(kBox, at(-1e200, 0), kBox, at(1e200, 0)));
    CHECK(is_refused(make_circle(0), at(1e-200, 0), make_circle(0), origin));
}

TEST_CASE("huge and denormal coordinates are in range") {
    const float huge = std::numeric_limits<float>::max(), tiny = std::numeric_limits<float>::denorm_min();
    const Shape large = Shape::from_raw(std::array<Vec2, 3>{{{-huge, -huge}, {huge, -huge}, {huge, huge}}}, 0);
    CHECK(near(distance(large, at(0, 0), large, at(3.0 * huge, 0)).distance, 1.0 * huge, kDouble));
    const Shape small = Shape::from_raw(std::array<Vec2, 3>{{{0, 0}, {tiny, 0}, {0, tiny}}}, 0);
    CHECK(distance(small, at(0, 0), small, at(3.0 * tiny, 0)).distance == 2.0 * static_cast<double>(tiny));
    CHECK(distance(small, at(0, 0), small, at(0, 0)).status == DistanceStatus::overlapping);
}

TEST_CASE("tiny gaps keep a unit normal and their sign") {
    // Box2D's distance returns a zero normal at a tiny gap; a gap below rounding is called touching, not overlapping.
    for (const double gap : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15}) {
        const DistanceResult r = distance(make_circle(0), at(0, 0), make_circle(0), at(gap, 0));
        CHECK(r.distance == gap);
        CHECK(r.normal == DVec2{1, 0});
        CHECK(r.status == DistanceStatus::separated);
        const DistanceResult boxes = distance(kBox, at(0, 0), kBox, at(2.0 + gap, 0.5));
        CHECK(boxes.normal == DVec2{1, 0});
        CHECK(boxes.status == (gap > 1e-14 ? DistanceStatus::separated : DistanceStatus::touching));
    }
}

TEST_CASE("a box of 1 cm that is 10 um above a box of 20 km has that distance") {
    const Shape ground = make_box({20000, 20000}), crumb = make_box({0.01f, 0.01f});
    const DistanceResult r = distance(ground, at(0, -10000), crumb, at(5000, 0.00501));
    CHECK(near(r.distance, 0.00501 - 0.5 * 0.01f, kFloat));
    CHECK(r.normal == DVec2{0, 1});
    CHECK(r.status == DistanceStatus::separated);
}

TEST_CASE("the trace is GJK to the same answer: bounds that close, supports that get nearer, each iteration counted") {
    const Shape a = make_box({2, 1}),
                b = make_polygon(std::array<Vec2, 5>{{{0, 0}, {2, 0.5f}, {2.5f, 2}, {1, 3}, {-1, 1}}});
    const Pose pa = at(0, 0, 10), pb = at(2.5, 1, -20);
    const DistanceTrace trace = trace_distance(a, pa, b, pb);
    const DistanceResult plain = distance(a, pa, b, pb);
    CHECK(trace.result.distance == plain.distance);
    REQUIRE(trace.steps.size() >= 2);
    CHECK(trace.steps.size() + 1 == trace.result.iterations);
    double upper = std::numeric_limits<double>::infinity(), lower = -upper;
    for (const TraceStep& step : trace.steps) {
        CHECK(step.upper <= upper);
        CHECK(step.lower >= lower);
        CHECK(length(step.closest) <= step.upper);
        upper = step.upper;
        lower = step.lower;
    }
    CHECK(lower <= plain.distance);
    CHECK(plain.distance <= upper);
    CHECK(upper - lower < 1e-13);
    CHECK(trace_distance(Shape{}, pa, b, pb).result.status == DistanceStatus::invalid);
}
