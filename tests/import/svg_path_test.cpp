// Path data, curves and transforms: against closed forms and curves evaluated by another method.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "import/svg/svg_path.hpp"
#include "import/svg/svg_text.hpp"
#include "support/near.hpp"

using namespace tumble;
using namespace tumble::scene;
using namespace tumble::test;

namespace {

constexpr double kTolerance = 0.01;

std::vector<Contour> flatten(const std::string& data, const Affine& map = {}, double tolerance = kTolerance) {
    Flattener flattener(map, tolerance);
    read_path(data, flattener);
    return flattener.take();
}

std::vector<DVec2> only_points(const std::string& data) {
    const std::vector<Contour> contours = flatten(data);
    REQUIRE(contours.size() == 1);
    return contours[0].points;
}

std::string path_error(const std::string& data) {
    try {
        flatten(data);
    } catch (const SvgError& error) {
        return error.what();
    }
    return "no error";
}

double distance_to_segment(DVec2 p, DVec2 a, DVec2 b) {
    const DVec2 e = b - a, d = p - a;
    const double t = std::clamp(dot(d, e) / length_sq(e), 0.0, 1.0);
    return length(d - t * e);
}

double distance_to_line(DVec2 p, const std::vector<DVec2>& points) {
    double least = 1e300;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        least = std::min(least, distance_to_segment(p, points[i], points[i + 1]));
    return least;
}

// By repeated interpolation, for any number of control points.
DVec2 bezier(std::vector<DVec2> points, double t) {
    while (points.size() > 1) {
        for (std::size_t i = 0; i + 1 < points.size(); ++i) points[i] = (1.0 - t) * points[i] + t * points[i + 1];
        points.pop_back();
    }
    return points[0];
}

// The chords stay within the tolerance of the curve, and the curve within the tolerance of the chords.
void check_bezier(const std::string& data, const std::vector<DVec2>& control) {
    const std::vector<DVec2> points = only_points(data);
    std::vector<DVec2> curve;
    for (int i = 0; i <= 5000; ++i) curve.push_back(bezier(control, i / 5000.0));
    for (const DVec2 p : curve) REQUIRE(distance_to_line(p, points) <= kTolerance);
    for (const DVec2 p : points) REQUIRE(distance_to_line(p, curve) <= kTolerance);
    CHECK(points.front() == control.front());
    CHECK(length(points.back() - control.back()) < 1e-12);
}

// Every point is at the radius from the center, the chords are within the tolerance, and the arc turns by `degrees`.
void check_arc(const std::string& data, DVec2 center, double radius, double degrees) {
    const std::vector<DVec2> points = only_points(data);
    double turn = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        CHECK(near(length(points[i] - center), radius, kDouble));
        if (i == 0) continue;
        const DVec2 a = points[i - 1] - center, b = points[i] - center;
        turn += std::atan2(cross(a, b), dot(a, b));
        CHECK(length(points[i] - points[i - 1]) <= std::sqrt(8.0 * radius * kTolerance) * 1.0001);  // sagitta c^2 / 8 r
    }
    CHECK(near(turn * 180.0 / kPi, degrees, kDouble));
}

}  // namespace

TEST_CASE("absolute and relative lines make the same square") {
    const std::vector<DVec2> square = {{1, 1}, {3, 1}, {3, 3}, {1, 3}};
    for (const char* data : {"M1 1 L3 1 L3 3 L1 3 Z", "M1,1 3,1 3,3 1,3z", "M1 1H3V3H1Z", "m1 1h2v2h-2z",
                             "m1 1 2 0 0 2-2 0z", "M1 1l2 0l0 2l-2 0l0-2", "M 1e0 +1.0 L3. 1L3 3 1 3 1 1"}) {
        const std::vector<Contour> contours = flatten(data);
        REQUIRE(contours.size() == 1);
        CHECK(contours[0].closed);
        CHECK(contours[0].points == square);
    }
    CHECK(!flatten("M1 1H3V3H1")[0].closed);
}

TEST_CASE("a move begins a contour; after Z the next one starts where the last began") {
    const std::vector<Contour> contours = flatten("M0 0 L1 0 L1 1 Z l-1 0 0-1 M5 5 l1 1 m2 2 l1 0");
    REQUIRE(contours.size() == 4);
    CHECK(contours[1].points == std::vector<DVec2>{{0, 0}, {-1, 0}, {-1, -1}});
    CHECK(contours[2].points == std::vector<DVec2>{{5, 5}, {6, 6}});
    CHECK(contours[3].points == std::vector<DVec2>{{8, 8}, {9, 8}});
    CHECK(flatten("M3 3").empty());
    CHECK(flatten("M3 3 Z M4 4 4 4").empty());
    CHECK(flatten("").empty());
}

TEST_CASE("curves stay within the tolerance of their chords") {
    check_bezier("M0 0 C 0 10 10 10 10 0", {{0, 0}, {0, 10}, {10, 10}, {10, 0}});
    check_bezier("M0 0 C 30 10 -20 10 10 0", {{0, 0}, {30, 10}, {-20, 10}, {10, 0}});
    check_bezier("m1 2 c 3 10 10 10 10 0", {{1, 2}, {4, 12}, {11, 12}, {11, 2}});
    check_bezier("M0 0 Q 5 20 10 0", {{0, 0}, {5, 20}, {10, 0}});
    check_bezier("m1 1 q 5 20 10 0", {{1, 1}, {6, 21}, {11, 1}});
}

TEST_CASE("smooth curves mirror the last control point of their kind, else start at the point") {
    CHECK(only_points("M0 0 C 0 5 5 5 5 0 S 10 -5 10 0") == only_points("M0 0 C 0 5 5 5 5 0 C 5 -5 10 -5 10 0"));
    CHECK(only_points("M0 0 c 0 5 5 5 5 0 s 5 -5 5 0") == only_points("M0 0 C 0 5 5 5 5 0 C 5 -5 10 -5 10 0"));
    CHECK(only_points("M0 0 Q 2 5 4 0 T 8 0 t 4 0") == only_points("M0 0 Q 2 5 4 0 Q 6 -5 8 0 Q 10 5 12 0"));
    CHECK(only_points("M0 0 Q 2 5 4 0 S 8 5 8 0") == only_points("M0 0 Q 2 5 4 0 C 4 0 8 5 8 0"));
    CHECK(only_points("M0 0 L 4 0 T 8 0") == only_points("M0 0 L 4 0 Q 4 0 8 0"));
}

TEST_CASE("the two flags of an arc select one of the four arcs between two points") {
    // From (50, 0) to (100, 50) with radius 50: the centres are (50, 50) and (100, 0).
    check_arc("M50 0 A50 50 0 0 1 100 50", {50, 50}, 50, 90);
    check_arc("M50 0 A50 50 0 1 0 100 50", {50, 50}, 50, -270);
    check_arc("M50 0 A50 50 0 0 0 100 50", {100, 0}, 50, -90);
    check_arc("M50 0 a50,50 0 1150 50", {100, 0}, 50, 270);  // the flags may touch what follows
    check_arc("M0 0 A5 5 30 0 1 10 0", {5, 0}, 5, 180);
    check_arc("M0 0 A1 1 0 0 0 10 0", {5, 0}, 5, -180);  // too short a radius grows until it reaches
    CHECK(only_points("M0 0 A0 5 0 0 1 10 0") == only_points("M0 0 L10 0"));
}

TEST_CASE("a turned elliptic arc lies on its ellipse") {
    // Half axes 6 and 3 at 30 degrees about the origin, from the end of the long axis to that of the short one.
    const double c = std::sqrt(0.75), s = 0.5;
    const auto text = [](double v) { return std::to_string(v); };
    const std::string data = "M" + text(6 * c) + " " + text(6 * s) + " A6 3 30 0 1 " + text(-3 * s) + " " + text(3 * c);
    const std::vector<DVec2> points = only_points(data);
    CHECK(points.size() > 8);
    for (const DVec2 p : points) {
        const double x = (c * p.x + s * p.y) / 6.0, y = (c * p.y - s * p.x) / 3.0;
        CHECK(near(x * x + y * y, 1.0, relative(1.5e-6)));  // six decimals: 2 sqrt(2) 5e-7
        CHECK(x > -1e-5);
        CHECK(y > -1e-5);
    }
}

TEST_CASE("an ellipse under a skew stays within the tolerance in the world") {
    const Affine map{{2.0, 0.5}, {-1.0, 3.0}, {7.0, -4.0}};
    Flattener flattener(map, kTolerance);
    flattener.move_to({5, 0});
    flattener.arc_to({{}, {5, 0}, {0, 2}, 0.0, 2.0 * kPi}, {5, 0});
    std::vector<DVec2> points = flattener.take().at(0).points;
    points.push_back(points.front());
    for (int i = 0; i < 5000; ++i) {
        const double t = 2.0 * kPi * i / 5000.0;
        REQUIRE(distance_to_line(apply(map, {5.0 * std::cos(t), 2.0 * std::sin(t)}), points) <= kTolerance);
    }
    // No more chords than four times what the longest half axis, about 11.6 m, needs: pi / acos(1 - 0.01 / 11.6)
    // = 76.
    CHECK(points.size() < 4 * 76);
}

TEST_CASE("transforms apply from right to left") {
    const auto image = [](const char* text) { return apply(parse_transform(text), {2, 1}); };
    CHECK(image("") == DVec2(2, 1));
    CHECK(image("translate(10)") == DVec2(12, 1));
    CHECK(image("translate(10, 20) scale(2)") == DVec2(14, 22));
    CHECK(image("scale(2) translate(10, 20)") == DVec2(24, 42));
    CHECK(image("rotate(90)") == DVec2(-1, 2));
    CHECK(image("rotate(-90)") == DVec2(1, -2));
    CHECK(image("rotate(90 2 0)") == DVec2(1, 0));
    CHECK(image("scale(2,-3)") == DVec2(4, -3));
    CHECK(image("matrix(1 2 3 4 5 6)") == DVec2(2 + 3 + 5, 4 + 4 + 6));
    CHECK(near(image("skewX(45)").x, 3.0, kDouble));
    CHECK(near(image("skewY(45)").y, 3.0, kDouble));
    CHECK_THROWS_AS(parse_transform("translate(1 2 3)"), SvgError);
    CHECK_THROWS_AS(parse_transform("turn(1)"), SvgError);
    CHECK_THROWS_AS(parse_transform("scale(1"), SvgError);
    CHECK_THROWS_AS(parse_transform("matrix(1 2 3 4 5 6 7)"), SvgError);
}

TEST_CASE("errors in path data state their position") {
    CHECK(path_error("L1 1") == "expected 'M' or 'm' to begin with at character 1, got \"L1 1\"");
    CHECK(path_error("M1 1 L2") == "expected a number at character 8, got the end");
    CHECK(path_error("M1 1 X") == "expected a path command at character 6, got \"X\"");
    CHECK(path_error("M1 inf") == "expected a number at character 4, got \"inf\"");
    CHECK(path_error("M0 0 A1 1 0 2 0 1 1").starts_with("expected a flag, 0 or 1 at character 13"));
    CHECK(path_error("M0 0 L1e999 0") == "a number is out of range");
    CHECK(path_error("M0 0 L1e300 0").starts_with("a point is farther than"));
    CHECK(path_error("M0 0 C 1e4 1e4 -1e4 1e4 1e4 0") == "no error");
    CHECK_THROWS_WITH_AS(flatten("M0 0 C 1e4 1e4 -1e4 1e4 1e4 0", {}, 1e-9),
                         "a curve needs more than 65535 chords for a tolerance of 1e-09 m", SvgError);
}
