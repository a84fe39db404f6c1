#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "support/near.hpp"
#include "tumble/shape.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

bool is_empty(const Aabb& box) { return !(box.lower.x <= box.upper.x); }

}  // namespace

TEST_CASE("bounds contain the shape and exceed it by a few float ulp at most, near and far") {
    std::mt19937_64 random(31);
    std::uniform_real_distribution<double> angle(-3.2, 3.2), unit(-1.0, 1.0);
    for (const double far : {0.0, 1.0, 1e3, 1e7}) {
        for (int sample = 0; sample < 2000; ++sample) {
            const Shape shape = make_box({1.5f, 0.7f}, sample % 2 ? 0.1f : 0.0f, {0.3f, -0.2f});
            const Pose pose{{far * unit(random), far * unit(random)}, make_rotation(angle(random))};
            const Aabb box = bounds(shape, pose);
            long double lowest = 1e300L, highest = -1e300L;
            for (int i = 0; i < 4; ++i) {
                const Vec2 v = shape.vertex(i);
                const long double x = static_cast<long double>(pose.rotation.c) * v.x -
                                      static_cast<long double>(pose.rotation.s) * v.y + pose.position.x;
                lowest = std::min(lowest, x - shape.radius());
                highest = std::max(highest, x + shape.radius());
            }
            CHECK(box.lower.x <= lowest);
            CHECK(box.upper.x >= highest);
            const long double few_ulp = 3 * 0x1p-23L * std::max(std::abs(lowest), std::abs(highest));
            CHECK(lowest - box.lower.x <= few_ulp);
            CHECK(box.upper.x - highest <= few_ulp);
        }
    }
}

TEST_CASE("bounds follow the shape in y as in x") {
    const Aabb box = bounds(make_capsule({0, 0}, {4, 0}, 0.5f), {{10, 20}, make_rotation_degrees(90)});
    CHECK(near(box.lower.x, 9.5, kFloat));
    CHECK(near(box.upper.x, 10.5, kFloat));
    CHECK(near(box.lower.y, 19.5, kFloat));
    CHECK(near(box.upper.y, 24.5, kFloat));
}

TEST_CASE("a shape that is not finite or has no vertices has an empty box; a position beyond float a half-open one") {
    const Shape circle = make_circle(1);
    CHECK(is_empty(bounds(Shape{}, Pose{})));
    CHECK(is_empty(bounds(circle, {{NAN, 0}, {}})));
    CHECK(is_empty(bounds(circle, {{0, INFINITY}, {}})));
    CHECK(is_empty(bounds(circle, {{0, 0}, {NAN, 0}})));
    const Aabb beyond = bounds(circle, {{1e300, -1e300}, {}});
    CHECK(std::isfinite(beyond.lower.x));
    CHECK(std::isinf(beyond.upper.x));
    CHECK(std::isinf(beyond.lower.y));
    CHECK(std::isfinite(beyond.upper.y));
}

TEST_CASE("extent and farthest distance include the radius") {
    const Shape capsule = make_capsule({-1, 0}, {2, 0}, 0.5f);
    CHECK(extent(capsule).larger == 4.0f);
    CHECK(extent(capsule).smaller == 1.0f);
    CHECK(near(farthest_distance(capsule, {-1, 0}), 3.5, kFloat));
    CHECK(farthest_distance(capsule, {-1, 0}) >= 3.5f);
    CHECK(near(farthest_distance(capsule, {2, 4}), 5.5, kFloat));  // 3-4-5 from the other end
}
