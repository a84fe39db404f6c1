#include "shape/hull.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "shape/orientation.hpp"

using namespace tumble;

namespace {

std::vector<Vec2> random_points(std::mt19937_64& random, int count, float range) {
    std::uniform_real_distribution<float> coordinate(-range, range);
    std::vector<Vec2> points;
    for (int i = 0; i < count; ++i) points.push_back({coordinate(random), coordinate(random)});
    return points;
}

// Signed area of the parallelogram in 64-bit-mantissa arithmetic: exact for coordinates on the grids used here.
long double turn(Vec2 a, Vec2 b, Vec2 c) {
    using L = long double;
    return (L(b.x) - a.x) * (L(c.y) - a.y) - (L(b.y) - a.y) * (L(c.x) - a.x);
}

std::vector<Vec2> vertices_of(const Shape& shape) {
    std::vector<Vec2> vertices;
    for (int i = 0; i < shape.vertex_count(); ++i) vertices.push_back(shape.vertex(i));
    return vertices;
}

}  // namespace

TEST_CASE("orientation agrees with exact integer arithmetic, also for points that are nearly collinear") {
    std::mt19937_64 random(11);
    std::uniform_int_distribution<int> coordinate(-(1 << 23), 1 << 23), nudge(-1, 1);
    int zero = 0, positive = 0;
    for (int sample = 0; sample < 30000; ++sample) {
        const long ax = coordinate(random), ay = coordinate(random), bx = coordinate(random), by = coordinate(random);
        const long cx = (ax + bx) / 2 + nudge(random), cy = (ay + by) / 2 + nudge(random);  // near the middle of ab
        const long exact = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
        const auto vec = [](long x, long y) { return Vec2{static_cast<float>(x), static_cast<float>(y)}; };
        const int found = orientation(vec(ax, ay), vec(bx, by), vec(cx, cy));
        CHECK(found == (exact > 0) - (exact < 0));
        zero += found == 0;
        positive += found > 0;
    }
    CHECK(zero > 500);
    CHECK(positive > 9000);
    CHECK(positive < 21000);
}

TEST_CASE("orientation sees one ulp across thirty binary orders") {
    const float ulp = 0x1p-23f;
    CHECK(orientation({0, 0}, {1, 1}, {0x1p30f, 0x1p30f}) == 0);
    CHECK(orientation({0, 0}, {1, 1 + ulp}, {0x1p30f, 0x1p30f}) == -1);
    CHECK(orientation({0, 0}, {1 + ulp, 1}, {0x1p30f, 0x1p30f}) == 1);
    // a = (2^-100, 0) is lost in every difference to b and c, and still decides.
    CHECK(orientation({0x1p-100f, 0}, {1, 1}, {2, 2}) == -1 * orientation({-0x1p-100f, 0}, {1, 1}, {2, 2}));
    CHECK(orientation({0x1p-100f, 0}, {1, 1}, {2, 2}) == -1);
}

TEST_CASE("the hull contains its points, turns left everywhere and starts at the lowest of the leftmost") {
    std::mt19937_64 random(12);
    for (const int count : {3, 4, 7, 20, 300}) {
        for (int sample = 0; sample < 200; ++sample) {
            const std::vector<Vec2> points = random_points(random, count, 4.0f);
            const std::vector<Vec2> hull = convex_hull(points);
            REQUIRE(hull.size() >= 3);
            for (std::size_t i = 0; i < hull.size(); ++i) {
                const Vec2 a = hull[i], b = hull[(i + 1) % hull.size()], c = hull[(i + 2) % hull.size()];
                CHECK(turn(a, b, c) > 0);
                for (const Vec2 point : points) CHECK(turn(a, b, point) >= 0);
                CHECK(std::find(points.begin(), points.end(), a) != points.end());
                CHECK((hull[0].x < a.x || (hull[0].x == a.x && hull[0].y <= a.y)));
            }
        }
    }
}

TEST_CASE("the report counts what happened to each point") {
    // A unit square with one corner given twice, one welded neighbour, a mid-edge point and two points inside.
    const std::vector<Vec2> points = {{0, 0},         {1, 0},    {1, 1},       {0, 1},       {1, 1},
                                      {1 + 2e-7f, 0}, {0.5f, 0}, {0.5f, 0.5f}, {0.25f, 0.5f}};
    HullReport report;
    const Shape shape = make_polygon(points, 0.0f, &report);
    CHECK(shape.vertex_count() == 4);
    CHECK(report.kept == 4);
    CHECK(report.duplicate == 2);
    CHECK(report.collinear == 1);
    CHECK(report.interior == 2);
}

TEST_CASE("welding is relative to the size: a 1 um square keeps its corners, and scaling by 2^k changes nothing") {
    std::mt19937_64 random(13);
    for (int sample = 0; sample < 200; ++sample) {
        const std::vector<Vec2> points = random_points(random, 30, 1.0f);
        const std::vector<Vec2> once = vertices_of(make_polygon(points));
        for (const float scale : {0x1p-40f, 0x1p-20f, 0x1p30f}) {
            std::vector<Vec2> scaled = points;
            for (Vec2& point : scaled) point = scale * point;
            std::vector<Vec2> expected = once;
            for (Vec2& vertex : expected) vertex = scale * vertex;
            CHECK(vertices_of(make_polygon(scaled)) == expected);
        }
    }
}

TEST_CASE("points on a line give a capsule, equal points a circle") {
    const std::vector<Vec2> line = {{0, 0}, {3, 1}, {6, 2}, {1.5f, 0.5f}};
    CHECK(make_polygon(line, 0.1f) == make_capsule({0, 0}, {6, 2}, 0.1f));
    const std::vector<Vec2> spot(5, Vec2{2, 3});
    CHECK(make_polygon(spot, 0.1f) == make_circle(0.1f, {2, 3}));
    // A sliver of height 1e-7 on a length of 1 is below the weld tolerance of 1e-6.
    const std::vector<Vec2> sliver = {{0, 0}, {0.5f, -1e-7f}, {1, 0}, {0.5f, 1e-7f}};
    CHECK(make_polygon(sliver) == make_segment({0, 0}, {1, 0}));
}

TEST_CASE("simplifying leaves no point farther outside than the weld distance, on a dense circle") {
    std::vector<Vec2> circle;
    for (int i = 0; i < 60000; ++i) {
        const SinCos at = sin_cos(2.0 * kPi * i / 60000.0);
        circle.push_back({static_cast<float>(at.cos), static_cast<float>(at.sin)});
    }
    const Shape shape = make_polygon(circle);
    const int count = shape.vertex_count();
    CHECK(count > 1000);
    CHECK(count < 4000);  // a chord of the tolerance's sagitta 2e-6 spans 4 sqrt(1e-6) = 0.004 rad: 1571 of them
    double farthest_outside = 0.0;
    for (std::size_t sample = 0; sample < circle.size(); sample += 7) {
        // The nearest edges are those around the same angle; the others see the point inside.
        for (int i = 0; i < count; ++i) {
            const DVec2 a(shape.vertex(i)), b(shape.vertex((i + 1) % count)), p(circle[sample]);
            if (length_sq(p - a) > 1e-3) continue;
            farthest_outside = std::max(farthest_outside, -cross(b - a, p - a) / length(b - a));
        }
    }
    CHECK(farthest_outside <= 2.0 * 1e-6 * (1 + 1e-6));
    CHECK(farthest_outside > 1e-7);
}

TEST_CASE("a large polygon keeps its vertices and is shared between copies") {
    std::vector<Vec2> points;
    for (int i = 0; i < 100; ++i) {
        const SinCos at = sin_cos(2.0 * kPi * i / 100.0);
        points.push_back({static_cast<float>(5 * at.cos), static_cast<float>(2 * at.sin)});
    }
    const Shape shape = make_polygon(points, 0.25f);
    CHECK(shape.vertex_count() == 100);
    Shape copy = make_circle(1.0f);
    copy = shape;
    CHECK(copy.large() == shape.large());
    CHECK(copy == shape);
    CHECK(shape.x().size() == 100);
}

TEST_CASE("an exact polygon keeps every point at which the hull turns") {
    // Below the weld tolerance of 1e-6 of the extent, on which make_polygon() makes a segment.
    const std::vector<Vec2> sliver = {{0.5f, 1e-7f}, {1, 0}, {0.5f, -1e-7f}, {0, 0}, {0.5f, 0}, {1, 0}};
    CHECK(make_exact_polygon(sliver, 0.1f) ==
          Shape::from_raw(std::vector<Vec2>{{0, 0}, {0.5f, -1e-7f}, {1, 0}, {0.5f, 1e-7f}}, 0.1f));
    // Neighbouring floats: an edge of one ulp.
    const float next = std::nextafter(1.0f, 2.0f);
    CHECK(make_exact_polygon(std::vector<Vec2>{{0, 0}, {1, 1}, {next, 1}, {1, next}}).vertex_count() == 3);
}

TEST_CASE("points exactly on a line give the segment of the two extreme ones, equal points a point") {
    const std::vector<Vec2> line = {{3, 1}, {0, 0}, {6, 2}, {1.5f, 0.5f}, {0, 0}};
    CHECK(make_exact_polygon(line) == make_segment({0, 0}, {6, 2}));
    CHECK(make_exact_polygon(std::vector<Vec2>(5, Vec2{2, 3}), 0.1f) == make_circle(0.1f, {2, 3}));
    CHECK_THROWS_AS(make_exact_polygon({}), std::invalid_argument);
    CHECK_THROWS_AS(make_exact_polygon(line, -1.0f), std::invalid_argument);
}

TEST_CASE("the edge angles of an exact polygon are sorted where edges turn by less than a double resolves") {
    for (const int exponent : {10, 40, 60, 100}) {
        CAPTURE(exponent);
        std::vector<Vec2> arc;
        for (int x = -20; x <= 20; ++x)
            arc.push_back({static_cast<float>(x), std::ldexp(static_cast<float>(x * x), -exponent)});
        arc.push_back({0, 9});
        for (int quarter = 0; quarter < 4; ++quarter) {
            for (Vec2& point : arc) point = {-point.y, point.x};
            const Shape shape = make_exact_polygon(arc);
            CHECK(shape.vertex_count() == 42);
            CHECK(shape.is_convex());
        }
    }
}
