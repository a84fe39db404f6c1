// Parts of a body that share edges are drawn as one shape.
#include "render/shapes/joined_parts.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>
#include <vector>

#include "support/near.hpp"

using namespace tumble;
using namespace tumble::render;
using namespace tumble::test;

namespace {

constexpr Paint kRed{{200, 0, 0, 255}, {100, 0, 0, 255}};
constexpr Paint kBlue{{0, 0, 200, 255}, {0, 0, 100, 255}};

// 10 pixels a metre, the origin in the middle.
const View kView{{0.0, 0.0}, 10.0, 640, 360};

Shape box(Vec2 lower, Vec2 upper, float radius = 0.0f) {
    const Vec2 corners[] = {lower, {upper.x, lower.y}, upper, {lower.x, upper.y}};
    return make_polygon(corners, radius);
}

int joined_count(std::initializer_list<Part> given) {
    std::vector<Part> parts(given);
    find_joined(parts);
    int count = 0;
    for (const Part& part : parts) count += part.is_joined;
    return count;
}

}  // namespace

TEST_CASE("parts that share a whole edge in one paint are joined, others are not") {
    const Shape left = box({0, 0}, {1, 1}), right = box({1, 0}, {2, 1}), far = box({3, 0}, {4, 1});
    const Shape lower_half = box({1, 0}, {2, 0.5f}), rounded = box({1, 0}, {2, 1}, 0.1f), ball = make_circle(1.0f);
    CHECK(joined_count({{&left, kRed}, {&far, kRed}, {&right, kRed}, {&ball, kRed}}) == 2);
    CHECK(joined_count({{&left, kRed}, {&right, kBlue}}) == 0);
    CHECK(joined_count({{&left, kRed}, {&lower_half, kRed}}) == 0);
    CHECK(joined_count({{&left, kRed}, {&rounded, kRed}}) == 0);
    // One on top of the other: both edges run in the same direction, so that the parts are on the same side.
    CHECK(joined_count({{&left, kRed}, {&left, kRed}}) == 0);
}

TEST_CASE("an L of three boxes is filled by its parts and has a line along each outer edge") {
    const Shape corner = box({0, 0}, {1, 1}), right = box({1, 0}, {3, 1}), top = box({0, 1}, {1, 4});
    std::vector<Part> parts{{&corner, kRed}, {&right, kRed}, {&top, kRed}};
    find_joined(parts);
    Layer layer;
    layer.outline_width = 2.0;
    add_joined_parts(layer, kView, parts, {});

    // Twice the signed area of all triangles: 1 + 2 + 3 square metres of 100 pixels each.
    double twice_area = 0.0;
    for (std::size_t i = 0; i < layer.mesh.size(); i += 3) {
        const MeshVertex *a = &layer.mesh[i], *b = a + 1, *c = a + 2;
        twice_area += static_cast<double>((b->x - a->x) * (c->y - a->y) - (c->x - a->x) * (b->y - a->y));
        CHECK(a->paint == flat(kRed.fill));
    }
    CHECK(near(twice_area, 2.0 * 600.0, kFloat));

    // 4 of the 12 edges are shared. The outline of the L: 3 + 1 + 2 + 3 + 1 + 4 m.
    CHECK(layer.boxes.size() == 8);
    double outline = 0.0;
    for (const BoxInstance& line : layer.boxes) {
        outline += 2.0 * static_cast<double>(line.half_x);
        CHECK(line.paint == flat(kRed.outline));
        CHECK(line.radius == 1.0f);
    }
    CHECK(near(outline, 140.0, kFloat));
}

TEST_CASE("joined parts are clipped to the frame, and those out of view are not drawn") {
    const Shape left = box({-1e6f, -1}, {0, 1}), right = box({0, -1}, {1e6f, 1}), far = box({1e6f, -1}, {2e6f, 1});
    std::vector<Part> parts{{&left, kRed}, {&right, kRed}, {&far, kRed}};
    find_joined(parts);
    Layer layer;
    layer.outline_width = 2.0;
    add_joined_parts(layer, kView, parts, {});
    CHECK(layer.mesh.size() == 12);  // two rectangles
    for (const MeshVertex& corner : layer.mesh) CHECK(std::abs(corner.x) <= 320.0f + 64.0f);
    CHECK(layer.boxes.size() == 4);  // along the top and the bottom
}
