#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "support/near.hpp"
#include "tumble/shape.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

template <typename Make>
std::string refusal(Make make) {
    try {
        make();
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return {};
}

bool contains(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

const float kNan = std::numeric_limits<float>::quiet_NaN();
const float kInf = std::numeric_limits<float>::infinity();

}  // namespace

TEST_CASE("a box has the outer size given, its core is smaller by the radius") {
    const Shape box = make_box({4, 2}, 0.5f, {10, 20});
    CHECK(box.vertex_count() == 4);
    CHECK(box.vertex(0) == Vec2{8.5f, 19.5f});
    CHECK(box.vertex(1) == Vec2{11.5f, 19.5f});
    CHECK(box.vertex(2) == Vec2{11.5f, 20.5f});
    CHECK(box.vertex(3) == Vec2{8.5f, 20.5f});
    CHECK(box.radius() == 0.5f);
}

TEST_CASE("a turned box turns counter-clockwise about its center") {
    const Shape box = make_box({4, 2}, 0.0f, {1, 0}, kPi / 2.0);
    // The corner at (-2, -1) from the center turns to (1, -2): at (2, -2).
    CHECK(near(box.vertex(0).x, 2.0, kFloat));
    CHECK(near(box.vertex(0).y, -2.0, kFloat));
}

TEST_CASE("a box whose radius takes a whole side is a capsule or a circle") {
    CHECK(make_box({4, 2}, 1.0f) == make_capsule({-1, 0}, {1, 0}, 1.0f));
    CHECK(make_box({2, 4}, 1.0f) == make_capsule({0, -1}, {0, 1}, 1.0f));
    CHECK(make_box({2, 2}, 1.0f) == make_circle(1.0f));
}

TEST_CASE("small shapes pad their lanes with vertex 0") {
    const Shape triangle = make_polygon(std::array<Vec2, 3>{{{0, 0}, {2, 0}, {0, 1}}});
    const float* x = triangle.x().data();
    const float* y = triangle.y().data();
    for (int lane = 3; lane < 8; ++lane) {
        CHECK(x[lane] == triangle.vertex(0).x);
        CHECK(y[lane] == triangle.vertex(0).y);
    }
}

TEST_CASE("the core radius is the farthest vertex, and not finite if one is not") {
    CHECK(make_box({6, 8}).core_radius() == 5.0);
    CHECK(Shape::from_raw(std::array<Vec2, 2>{{{3, 4}, {0, 1}}}, 7.0f).core_radius() == 5.0);
    for (const Vec2 bad : {Vec2{kNan, 0}, Vec2{0, kInf}}) {
        CHECK_FALSE(std::isfinite(Shape::from_raw(std::array<Vec2, 3>{{bad, {3, 4}, {0, 1}}}, 0).core_radius()));
        CHECK_FALSE(std::isfinite(Shape::from_raw(std::array<Vec2, 3>{{{3, 4}, bad, {0, 1}}}, 0).core_radius()));
    }
}

TEST_CASE("a chain is a segment between each two points, and one more if closed") {
    const std::array<Vec2, 3> points = {{{0, 0}, {1, 0}, {1, 1}}};
    const std::vector<Shape> open = make_chain(points, false), closed = make_chain(points, true);
    REQUIRE(open.size() == 2);
    CHECK(open[1] == make_segment({1, 0}, {1, 1}));
    REQUIRE(closed.size() == 3);
    CHECK(closed[2] == make_segment({1, 1}, {0, 0}));
}

TEST_CASE("factories refuse what is not finite or negative and print it") {
    CHECK(contains(refusal([] { make_circle(-1.5f); }), "-1.5"));
    CHECK(contains(refusal([] { make_circle(kNan); }), "nan"));
    CHECK(contains(refusal([] { make_circle(1, {kInf, 2}); }), "(inf, 2)"));
    CHECK(contains(refusal([] { make_capsule({0, 0}, {1, kNan}, 1); }), "(1, nan)"));
    CHECK(contains(refusal([] { make_segment({0, 0}, {kInf, 0}); }), "(inf, 0)"));
    CHECK(contains(refusal([] { make_box({0, 1}); }), "(0, 1)"));
    CHECK(contains(refusal([] { make_box({2, 1}, 0.75f); }), "0.75"));
    CHECK(contains(refusal([] { make_box({2, 1}, 0, {}, std::nan("")); }), "nan"));
    CHECK(contains(refusal([] { make_polygon({}); }), "got 0"));
    CHECK(contains(refusal([] { make_polygon(std::array<Vec2, 2>{{{0, 0}, {kNan, 0}}}); }), "point 1"));
    CHECK(contains(refusal([] { make_chain(std::array<Vec2, 1>{{{0, 0}}}, false); }), "got 1"));
    CHECK(contains(refusal([] { Shape::from_raw(std::vector<Vec2>(65536), 0); }), "65536"));
    CHECK_NOTHROW(Shape::from_raw(std::vector<Vec2>(65535), 0));
}

TEST_CASE("a box whose corners coincide in float is refused, not turned into something else") {
    CHECK(contains(refusal([] { make_box({0.01f, 0.01f}, 0, {1e7f, 0}); }), "distinct corners"));
}
