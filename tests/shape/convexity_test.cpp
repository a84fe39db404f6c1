#include "shape/convexity.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "tumble/shape.hpp"

using namespace tumble;

namespace {

const std::vector<Vec2> kPentagon = {{0, 0}, {2, 0}, {3, 1}, {1, 3}, {-1, 1}};

std::vector<Vec2> reversed(std::vector<Vec2> points) {
    std::reverse(points.begin(), points.end());
    return points;
}

}  // namespace

TEST_CASE("an outline is convex if no vertex lies to the right of an edge") {
    CHECK(is_convex_outline(kPentagon));
    CHECK_FALSE(is_convex_outline(reversed(kPentagon)));                                          // clockwise
    CHECK_FALSE(is_convex_outline(std::array<Vec2, 4>{{{0, 0}, {2, 0}, {0.5f, 0.5f}, {0, 2}}}));  // a dart
    CHECK_FALSE(is_convex_outline(std::array<Vec2, 4>{{{0, 0}, {1, 1}, {1, 0}, {0, 1}}}));        // a bow tie
    std::vector<Vec2> star;  // each turn is to the left, twice round
    for (std::size_t i = 0; i < 5; ++i) star.push_back(kPentagon[2 * i % 5]);
    CHECK_FALSE(is_convex_outline(star));
}

TEST_CASE("collinear and duplicate vertices do not hurt convexity; one ulp to the right of an edge does") {
    const float ulp = 0x1p-23f;
    CHECK(is_convex_outline(std::array<Vec2, 5>{{{0, 0}, {1, 0}, {2, 0}, {2, 0}, {1, 1}}}));
    CHECK(is_convex_outline(std::array<Vec2, 4>{{{0, 0}, {0, 0}, {0, 0}, {0, 0}}}));
    CHECK(is_convex_outline(std::array<Vec2, 3>{{{0, 0}, {2, 0}, {1, 0}}}));
    CHECK(is_convex_outline(std::array<Vec2, 1>{{{5, 5}}}));
    CHECK(is_convex_outline(std::array<Vec2, 4>{{{0, 1}, {1, 1}, {2, 1}, {1, 2}}}));
    CHECK_FALSE(is_convex_outline(std::array<Vec2, 4>{{{0, 1}, {1, 1 + ulp}, {2, 1}, {1, 2}}}));
}

TEST_CASE("a shape reports whether it is convex, with eight vertices and with more") {
    CHECK(Shape::from_raw(kPentagon, 1).is_convex());
    CHECK(make_box({1, 2}, 0.1f).is_convex());
    CHECK(make_circle(1).is_convex());
    CHECK_FALSE(Shape::from_raw(reversed(kPentagon), 1).is_convex());
    std::vector<Vec2> round;
    for (int i = 0; i < 20; ++i) {
        const SinCos at = sin_cos(i * kPi / 10.0);
        round.push_back(to_float(DVec2{at.cos, at.sin}));
    }
    CHECK(Shape::from_raw(round, 0).is_convex());
    CHECK_FALSE(Shape::from_raw(reversed(round), 0).is_convex());
    round[3] = round[4];
    CHECK_FALSE(Shape::from_raw(round, 0).is_convex());
}
