// Notes and the title card: when they show, where, and in which layer.
#include "render/frame/notes.hpp"

#include <doctest/doctest.h>

#include "render/hand_made_scene.hpp"
#include "support/near.hpp"

using namespace tumble;
using namespace tumble::render;
using namespace tumble::test;

namespace {

// 20 pixels a metre, the origin in the middle of 640 x 360.
const View kView{{0.0, 0.0}, 20.0, 640, 360};

struct Plates {
    DrawList list;
    explicit Plates(const SceneCamera& camera, const SceneWorld& world, double time = 0.0, const View& view = kView) {
        GlyphAtlas atlas;
        add_notes(list, atlas, view, camera, world, time, colors_of(Theme::light));
    }
};

}  // namespace

TEST_CASE("a note shows from its first to before its last time, at its position or above its body") {
    HandMadeScene s;
    const BodyId crate = s.add_dynamic("crate", {2.0, 3.0}, make_box({1.0f, 2.0f}));
    const SceneNote fixed{.text = "here", .position = DVec2{1.0, 2.0}, .from = 1.0, .until = 2.0};
    CHECK(position_of(fixed, s.built, 0.99) == std::nullopt);
    CHECK(position_of(fixed, s.built, 1.0) == DVec2{1.0, 2.0});
    CHECK(position_of(fixed, s.built, 2.0) == std::nullopt);
    const SceneNote above{.text = "crate", .above = "crate"};
    const DVec2 top = position_of(above, s.built, 9.0).value();
    CHECK(near(top.x, 2.0, absolute(1e-6)));
    CHECK(near(top.y, 4.0, absolute(1e-6)));  // half its height of 2 m above its middle
    s.built.world.destroy_body(crate);
    CHECK(position_of(above, s.built, 9.0) == std::nullopt);
}

TEST_CASE("the plate of a note is above its point, and moved into the frame at its edge") {
    const HandMadeScene s;
    const Plates middle({.notes = {{.text = "one\ntwo", .position = DVec2{0.0, 0.0}}}}, s.built);
    REQUIRE(middle.list.notes.boxes.size() == 1);
    const BoxInstance& plate = middle.list.notes.boxes[0];
    CHECK(near(plate.x, 0.0f, absolute(0.5f)));
    CHECK(near(plate.y - plate.half_y - plate.radius, 5.25f, absolute(0.5f)));  // 7 pixels at 720 rows
    CHECK(middle.list.notes.glyphs.size() == 6);

    const Plates corner({.notes = {{.text = "a longer text", .position = DVec2{16.0, 9.0}}}}, s.built);
    REQUIRE(corner.list.notes.boxes.size() == 1);
    const BoxInstance& moved = corner.list.notes.boxes[0];
    CHECK(moved.x + moved.half_x + moved.radius < 320.0f);
    CHECK(moved.y + moved.half_y + moved.radius < 180.0f);
}

TEST_CASE("a note out of view, and one in a small frame, is not drawn") {
    const HandMadeScene s;
    const SceneCamera camera{.notes = {{.text = "far", .position = DVec2{17.0, 0.0}}}};
    CHECK(Plates(camera, s.built).list.notes.boxes.empty());
    const SceneCamera near_by{.notes = {{.text = "near", .position = DVec2{}}}};
    CHECK(Plates(near_by, s.built, 0.0, {{}, 20.0, 399, 360}).list.notes.boxes.empty());
    CHECK(Plates(near_by, s.built, 0.0, {{}, 20.0, 400, 225}).list.notes.boxes.size() == 1);
}

TEST_CASE("the title card is in the middle until its time is over, and then the notes show") {
    const HandMadeScene s;
    const SceneCamera camera{.notes = {{.text = "note", .position = DVec2{}}},
                             .card = SceneCard{"Title", "below", 1.5}};
    const Plates first(camera, s.built, 1.49);
    REQUIRE(first.list.card.boxes.size() == 2);  // its edge and itself
    CHECK(near(first.list.card.boxes[0].x, 0.0f, absolute(0.5f)));
    CHECK(near(first.list.card.boxes[0].y, 0.0f, absolute(0.5f)));
    CHECK(first.list.card.glyphs.size() == 10);
    CHECK(first.list.notes.boxes.empty());
    const Plates later(camera, s.built, 1.5);
    CHECK(later.list.card.boxes.empty());
    CHECK(later.list.notes.boxes.size() == 1);
}
