// The lines of springs, ropes and pulleys, in pixels.
#include "render/frame/joint_paths.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/near.hpp"

using namespace tumble;
using namespace tumble::render;
using namespace tumble::test;

namespace {

double length_of(const std::vector<DVec2>& path) {
    double sum = 0.0;
    for (std::size_t i = 1; i < path.size(); ++i) sum += length(path[i] - path[i - 1]);
    return sum;
}

// The distance of the point from the segment.
double distance_to(DVec2 point, DVec2 from, DVec2 to) {
    const DVec2 along = to - from;
    const double t = std::clamp(dot(point - from, along) / std::max(length_sq(along), 1e-300), 0.0, 1.0);
    return length(point - (from + t * along));
}

void check_around(const PulleyPath& path, DVec2 wheel) {
    double nearest = 1e9;
    for (std::size_t i = 1; i < path.points.size(); ++i)
        nearest = std::min(nearest, distance_to(wheel, path.points[i - 1], path.points[i]));
    // The arc is drawn as chords: at a quarter turn in 16 parts they are 1 - cos(pi / 64) = 0.12 % inside the wheel, at
    // three quarters 1.1 %.
    CHECK(nearest <= path.radius * (1.0 + 1e-9));
    CHECK(nearest >= 0.98 * path.radius);
}

}  // namespace

TEST_CASE("a coil keeps its turns when it is stretched, and its width") {
    const DVec2 a{10.0, 20.0};
    const std::vector<DVec2> rest = coil_path(a, {110.0, 20.0}, 100.0, 8.0);
    const std::vector<DVec2> stretched = coil_path(a, {10.0, 220.0}, 100.0, 8.0);
    CHECK(rest.size() == stretched.size());
    CHECK(rest.front() == a);
    CHECK(stretched.back() == DVec2{10.0, 220.0});
    double widest = 0.0;
    for (const DVec2 point : stretched) widest = std::max(widest, std::abs(point.x - 10.0));
    CHECK(near(widest, 8.0, kDouble));
    CHECK(coil_path(a, a, 100.0, 8.0).size() == 2);
}

TEST_CASE("a taut rope is straight, and a slack one hangs down with about its length") {
    const DVec2 a{0.0, 0.0}, b{100.0, 30.0}, down{0.0, -10.0};
    const double distance = length(b - a);
    CHECK(rope_path(a, b, distance, down).size() == 2);
    CHECK(rope_path(a, b, 1.2 * distance, {}).size() == 2);  // no gravity
    for (const double slack : {1.02, 1.1, 1.3}) {
        const std::vector<DVec2> path = rope_path(a, b, slack * distance, down);
        CHECK(path.front() == a);
        CHECK(length(path.back() - b) < 1e-9);
        CHECK(path[path.size() / 2].y < 15.0);
        CHECK(std::abs(length_of(path) / (slack * distance) - 1.0) < 0.05);
    }
}

TEST_CASE("the rope of a pulley touches both wheels and enters neither") {
    const DVec2 down{0.0, -10.0};
    struct Case {
        DVec2 a, ground_a, ground_b, b;
    };
    for (const Case& c : {Case{{0, 0}, {0, 100}, {80, 100}, {80, 20}},      // both hang
                          Case{{-60, 30}, {0, 100}, {80, 100}, {140, 50}},  // both swing out
                          Case{{60, 30}, {0, 100}, {80, 100}, {80, 20}},    // one swings in
                          Case{{-90, 10}, {0, 10}, {40, 150}, {40, 60}},    // a winch: level, up, down
                          Case{{80, 20}, {80, 100}, {0, 100}, {0, 0}}}) {   // the first hangs on the right
        CAPTURE(c.a.x);
        const PulleyPath path = pulley_path(c.a, c.ground_a, c.ground_b, c.b, 10.0, down);
        CHECK(path.radius == 10.0);
        CHECK(path.points.front() == c.a);
        CHECK(path.points.back() == c.b);
        check_around(path, path.wheel_a);
        check_around(path, path.wheel_b);
        // Once around a wheel of radius 10 would add 63.
        const double straight = length(c.ground_a - c.a) + length(c.ground_b - c.ground_a) + length(c.b - c.ground_b);
        CHECK(std::abs(length_of(path.points) - straight) < 60.0);
    }
    const PulleyPath hanging = pulley_path({0, 0}, {0, 100}, {80, 100}, {80, 20}, 10.0, down);
    CHECK(length(hanging.points[1] - DVec2{0.0, 100.0}) < 1e-9);  // straight up to the ground anchor
    CHECK(pulley_path({0, 0}, {0, 9}, {6, 9}, {6, 0}, 10.0, down).radius == 2.0);
    CHECK(pulley_path({0, 0}, {0, 9}, {0, 9}, {6, 0}, 10.0, down).radius == 0.0);
    const PulleyPath floating = pulley_path({0, 0}, {0, 100}, {80, 100}, {80, 20}, 10.0, {});
    CHECK(floating.wheel_a == DVec2{0.0, 100.0});
}
