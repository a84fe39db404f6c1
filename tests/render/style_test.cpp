// Hatching, shadows and outlines of a style, as primitives.
#include <doctest/doctest.h>

#include <cmath>

#include "render/frame/draw_list.hpp"
#include "render/hand_made_scene.hpp"
#include "render/shapes/hatching.hpp"
#include "render/style/style.hpp"
#include "support/near.hpp"

using namespace tumble;
using namespace tumble::render;
using namespace tumble::test;

namespace {

// 10 pixels a metre, detail 1 at 720 rows.
const View kView{{0.0, 0.0}, 10.0, 1280, 720};

DrawList drawn(const HandMadeScene& s, const SceneStyle& style) {
    DrawList list;
    build_draw_list(list, s.scene, s.built, kView, {}, Look(style));
    return list;
}

HandMadeScene box_on_floor() {
    HandMadeScene s;
    s.add_static("floor", {0.0, -1.0}, make_box({20.0f, 2.0f}));
    s.add_dynamic("box", {3.0, 1.5}, make_box({3.0f, 3.0f}));
    return s;
}

}  // namespace

TEST_CASE("a style without options adds nothing, and each option adds to its own layer") {
    const HandMadeScene s = box_on_floor();
    const DrawList plain = drawn(s, {});
    CHECK(plain.hatching.boxes.empty());
    CHECK(plain.shadows.boxes.empty());
    const DrawList all = drawn(s, {.hatching = true, .shadows = true});
    CHECK(all.hatching.boxes.size() > 10);
    CHECK(all.shadows.boxes.size() == 1);
    CHECK(all.bodies.boxes.size() == plain.bodies.boxes.size());
}

TEST_CASE("the lines of a hatching are 12 pixels apart, at 45 degrees, and cover the area evenly") {
    Layer layer;
    add_hatching(layer, kView, make_box({40.0f, 30.0f}), {}, {});
    REQUIRE(layer.boxes.size() > 20);
    double total = 0.0;
    for (std::size_t i = 0; i < layer.boxes.size(); ++i) {
        const BoxInstance& line = layer.boxes[i];
        CHECK(near(line.axis_x, line.axis_y, absolute(1e-5f)));
        total += 2.0 * double{line.half_x};
        if (i == 0) continue;
        const double before = double{layer.boxes[i - 1].x} - double{layer.boxes[i - 1].y};
        CHECK(near((double{line.x} - double{line.y} - before) / std::sqrt(2.0), style::kHatchSpacing, absolute(1e-3)));
    }
    // Parallel lines at a distance d across an area A have the length A / d, but for half a line at the corners.
    CHECK(near(total * style::kHatchSpacing, 400.0 * 300.0, relative(0.02)));
}

TEST_CASE("hatching stays with the world when the view moves") {
    const Shape shape = make_box({10.0f, 10.0f});
    Layer before, after;
    add_hatching(before, kView, shape, {}, {});
    View moved = kView;
    moved.center = {0.3, 0.0};  // 3 pixels
    add_hatching(after, moved, shape, {}, {});
    REQUIRE(before.boxes.size() == after.boxes.size());
    for (std::size_t i = 0; i < before.boxes.size(); ++i)
        CHECK(near(after.boxes[i].x, before.boxes[i].x - 3.0f, absolute(1e-3f)));
}

// 1e16 and 1e19 pixels from the origin the neighbours of a double are 2 and 2048 pixels away.
TEST_CASE("hatching a million metres from the origin is as even as at it, however large a metre is") {
    for (const double scale : {1e10, 1e13}) {
        Layer layer;
        const View view{{1e6, 0.0}, scale, 1280, 720};
        add_hatching(layer, view, make_box({1.0f, 1.0f}), {view.center, {}}, {});
        // The frame is 1280 + 720 pixels wide in x - y, and a line is 12 sqrt(2) after the last.
        CHECK(near(static_cast<double>(layer.boxes.size()), 2000.0 / (12.0 * std::sqrt(2.0)), absolute(1.0)));
        for (std::size_t i = 1; i < layer.boxes.size(); ++i) {
            const auto at = [&](std::size_t line) { return double{layer.boxes[line].x} - double{layer.boxes[line].y}; };
            REQUIRE(near((at(i) - at(i - 1)) / std::sqrt(2.0), 12.0, absolute(1e-3)));
        }
    }
}

TEST_CASE("shapes without area and shapes out of view have no hatching") {
    Layer layer;
    add_hatching(layer, kView, make_segment({-5.0f, 0.0f}, {5.0f, 0.0f}), {}, {});
    add_hatching(layer, kView, make_box({10.0f, 10.0f}), {{500.0, 0.0}, {}}, {});
    CHECK(layer.boxes.empty());
}

TEST_CASE("a shadow has the shape of its body, to the lower right of it") {
    const DrawList list = drawn(box_on_floor(), {.shadows = true});
    REQUIRE(list.shadows.boxes.size() == 1);
    const BoxInstance &shadow = list.shadows.boxes[0], &body = list.bodies.boxes.at(0);
    CHECK(near(shadow.x - body.x, 5.0f, absolute(1e-3f)));
    CHECK(near(shadow.y - body.y, -6.0f, absolute(1e-3f)));
    CHECK(shadow.half_x == body.half_x);
    CHECK(shadow.paint.fill == colors_of(Theme::light).shadow);
}

TEST_CASE("without outlines the edge of a shape has the colour of its fill; a segment keeps its line") {
    HandMadeScene s = box_on_floor();
    s.add_static("edge", {0.0, 5.0}, make_segment({-5.0f, 0.0f}, {5.0f, 0.0f}));
    const DrawList with = drawn(s, {}), without = drawn(s, {.outlines = false});
    CHECK(with.bodies.boxes.at(0).paint.outline != with.bodies.boxes.at(0).paint.fill);
    CHECK(without.bodies.boxes.at(0).paint == flat(with.bodies.boxes.at(0).paint.fill));
    CHECK(without.ground.boxes.at(1).paint == with.ground.boxes.at(1).paint);
    CHECK(without.details.boxes.at(0).paint == with.details.boxes.at(0).paint);  // the mark stays visible
}
