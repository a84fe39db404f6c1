// The camera of a scene that does not state one: fitted to the moving bodies, with the ground below them.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "render/hand_made_scene.hpp"
#include "support/near.hpp"
#include "tumble/render.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_import.hpp"
#include "tumble/scene_run.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

constexpr double kAspect = 16.0 / 9.0;

// The sides of a camera's frame in world coordinates.
struct Framing {
    double left, right, bottom, top;

    Framing(const Camera& camera, double aspect)
        : left(camera.center.x - 0.5 * aspect * camera.height),
          right(camera.center.x + 0.5 * aspect * camera.height),
          bottom(camera.center.y - 0.5 * camera.height),
          top(camera.center.y + 0.5 * camera.height) {}

    bool contains(DVec2 lower, DVec2 upper) const {
        return left <= lower.x && upper.x <= right && bottom <= lower.y && upper.y <= top;
    }
};

HandMadeScene pyramid(DVec2 origin) {
    HandMadeScene s;
    s.add_static("ground", origin + DVec2{0.0, -1.0}, make_box({200.0f, 2.0f}));
    for (int row = 0; row < 10; ++row)
        for (int i = 0; i < 10 - row; ++i)
            s.add_dynamic("crate", origin + DVec2{i - 4.5 + 0.5 * row, row + 0.5}, make_box({1.0f, 1.0f}));
    return s;
}

}  // namespace

TEST_CASE("a long ground does not shrink the pyramid on it") {
    for (const DVec2 origin : {DVec2{}, DVec2{10000.0, -3000.0}}) {
        HandMadeScene s = pyramid(origin);
        const Camera camera = make_camera(s.scene, s.built, kAspect);
        const Framing frame(camera, kAspect);
        CHECK(frame.contains(origin + DVec2{-5.0, -0.3}, origin + DVec2{5.0, 10.0}));
        CHECK(camera.height < 13.0);  // the pyramid is 10 m high
    }
}

TEST_CASE("static shapes that fit are shown whole") {
    HandMadeScene s;
    s.add_static("floor", {0.0, -0.5}, make_box({14.0f, 1.0f}));
    s.add_static("left wall", {-6.5, 3.0}, make_box({1.0f, 6.0f}));
    s.add_static("right wall", {6.5, 3.0}, make_box({1.0f, 6.0f}));
    s.add_dynamic("ball", {0.0, 5.0}, make_circle(0.5f));
    const Camera camera = make_camera(s.scene, s.built, kAspect);
    CHECK(Framing(camera, kAspect).contains({-7.0, -1.0}, {7.0, 6.0}));
    CHECK(camera.height < 14.0);  // twice the height of the walls and the floor
}

TEST_CASE("the ground far below a body is in view, but nothing below the first ground as wide as all bodies") {
    HandMadeScene s;
    s.add_dynamic("crate", {0.0, 20.0}, make_box({2.0f, 2.0f}));
    s.add_static("ground", {0.0, -500.0}, make_box({1000.0f, 1000.0f}));
    s.add_static("cellar", {0.0, -50.0}, make_box({1000.0f, 1.0f}));
    const Camera camera = make_camera(s.scene, s.built, kAspect);
    const Framing frame(camera, kAspect);
    CHECK(frame.contains({-1.0, 0.0}, {1.0, 21.0}));
    CHECK(frame.bottom > -10.0);
}

TEST_CASE("a turning beam is in view at every angle") {
    HandMadeScene s;
    const BodyId post = s.add_static("post", {0.0, 0.0}, make_circle(0.1f));
    const BodyId beam = s.add_dynamic("beam", {0.0, 0.0}, make_box({10.0f, 0.5f}));
    s.built.joints.push_back({s.built.world.create_joint(RevoluteJointDef{post, beam, {}, {}}), 0, ""});
    const Camera camera = make_camera(s.scene, s.built, kAspect);
    CHECK(Framing(camera, kAspect).contains({-5.0, -5.0}, {5.0, 5.0}));
    CHECK(camera.height < 20.0);  // twice the length of the beam
}

TEST_CASE("the center and the height that a scene states are used unchanged") {
    HandMadeScene s = pyramid({});
    s.scene.camera.center = DVec2{3.0, 4.0};
    s.scene.camera.height = 7.5;
    const Camera camera = make_camera(s.scene, s.built, kAspect);
    CHECK(camera.center == DVec2{3.0, 4.0});
    CHECK(camera.height == 7.5);
    s.scene.camera.height.reset();
    CHECK(Framing(make_camera(s.scene, s.built, kAspect), kAspect).contains({-5.0, -0.3}, {5.0, 10.0}));
}

TEST_CASE("a camera that follows a body keeps its offset from it") {
    HandMadeScene s = pyramid({});
    const BodyId ball = s.add_dynamic("ball", {20.0, 3.0}, make_circle(0.5f));
    s.scene.camera.follow = "ball";
    CHECK(make_camera(s.scene, s.built, kAspect).center == DVec2{20.0, 3.0});
    s.scene.camera.center = DVec2{18.0, 5.0};
    const Camera start = make_camera(s.scene, s.built, kAspect);
    CHECK(start.center == DVec2{18.0, 5.0});
    s.built.world.set_velocity(ball, {6.0f, 0.0f}, 0.0f);
    for (int i = 0; i < 10; ++i) s.built.world.step();
    const DVec2 now = s.built.world.state(ball).pose.position;
    CHECK(now.x > 20.5);
    const Camera moved = move_camera(start, s.scene, s.built);
    CHECK(length(moved.center - (now + DVec2{-2.0, 2.0})) < 1e-12);
    CHECK(moved.height == start.height);
    s.built.world.destroy_body(ball);
    CHECK(move_camera(start, s.scene, s.built).center == start.center);
}

TEST_CASE("a world without moving bodies, without shapes or of one point has a camera") {
    HandMadeScene s;
    const Camera nothing = make_camera(s.scene, s.built, kAspect);
    CHECK(nothing.height > 0.0);
    CHECK(nothing.center == DVec2{});
    s.add_static("wall", {7.0, 8.0}, make_box({4.0f, 2.0f}));
    CHECK(Framing(make_camera(s.scene, s.built, kAspect), kAspect).contains({5.0, 7.0}, {9.0, 9.0}));
    HandMadeScene point;
    point.add_dynamic("point", {1.0, 2.0}, make_circle(0.0f));
    const Camera camera = make_camera(point.scene, point.built, kAspect);
    CHECK(camera.height > 0.0);
    CHECK(std::isfinite(camera.height));
}

TEST_CASE("a body that the timeline spawns is in view from its first pose over its whole flight") {
    HandMadeScene s;
    s.scene.world.duration = 1.5;
    s.add_static("ground", {0.0, -0.5}, make_box({400.0f, 1.0f}));
    s.add_dynamic("crate", {0.0, 0.5}, make_box({1.0f, 1.0f}));
    SceneEvent event;
    event.at = 0.25;
    event.spawn.emplace();
    event.spawn->name = "stone";
    event.spawn->position = {6.0, 3.0};
    event.spawn->velocity = {-4.0, 5.0};
    event.spawn->shapes.push_back({CircleGeometry{0.25, {}}, "", ""});
    s.scene.timeline.push_back(event);
    const Framing frame(make_camera(s.scene, s.built, kAspect), kAspect);
    // It rises by v^2 / 2 g = 1.25 m and lands 1.3 s later, 5 m farther to the left.
    CHECK(frame.contains({-0.5, 0.0}, {6.25, 4.4}));
    CHECK(frame.top < 8.0);
    CHECK(frame.right < 12.0);
}

TEST_CASE("a body that falls off the level does not enlarge the frame") {
    HandMadeScene s;
    s.add_static("table", {0.0, -0.5}, make_box({6.0f, 1.0f}));
    s.add_dynamic("stays", {-1.0, 0.5}, make_box({1.0f, 1.0f}));
    s.add_dynamic("falls", {3.2, 0.5}, make_box({1.0f, 1.0f}));  // over the edge: 125 m down in 5 s
    const Camera camera = make_camera(s.scene, s.built, kAspect);
    CHECK(camera.height < 6.0);
    CHECK(Framing(camera, kAspect).contains({-3.0, -0.3}, {3.7, 1.0}));
}

TEST_CASE("the camera follows a vehicle that drives away, and stays if most bodies do") {
    const std::string floor =
        R"({"name": "floor", "type": "static", "shapes": [{"segment": {"from": [-9, 0], "to": [900, 0]}}]})";
    const std::string wheel =
        R"({"name": "wheel", "position": [0, 0.5], "velocity": [30, 0], "shapes": [{"circle": {"radius": 0.5}}]})";
    const std::string box =
        R"({"name": "box", "position": [1, 4], "velocity": [30, 0], "gravity_scale": 0, "shapes": [{"box": {"size": [2, 1]}}]})";
    const std::string still =
        R"({"position": [-3, 0.5], "repeat": {"grid": {"columns": 3, "spacing": [-1, 0]}}, "shapes": [{"box": {"size": [0.5, 1]}}]})";
    const auto camera_of = [&](const std::string& bodies, SceneWorld& built) {
        const Scene scene = parse_scene(R"({"format": 1, "bodies": [)" + bodies + "]}", "scene.json");
        built = build_world(scene);
        return make_camera(scene, built, kAspect);
    };
    SceneWorld built = build_world({});
    const Camera following = camera_of(floor + ", " + wheel + ", " + box, built);
    CHECK(following.follows == built.bodies.at(2).id);  // the larger of the two
    CHECK(following.center == DVec2{1.0, 4.0});
    CHECK(camera_of(floor + ", " + wheel + ", " + still, built).follows == BodyId{});
    const std::string stated =
        R"({"format": 1, "camera": {"center": [0, 2]}, "bodies": [)" + floor + ", " + wheel + "]}";
    const Scene scene = parse_scene(stated, "scene.json");
    built = build_world(scene);
    CHECK(make_camera(scene, built, kAspect).follows == BodyId{});
}

TEST_CASE("the frame shows the room in which a body stays, and the camera does not follow it there") {
    // A puck of 0.4 m crosses a rink of 8 m by 4 m, or of 20 m by 10 m, which is more than 24 times as large.
    const auto camera_on_rink = [](const std::string& points, SceneWorld& built) {
        const Scene scene = parse_scene(
            R"({"format": 1, "world": {"gravity": [0, 0], "duration": 3}, "bodies": [
                {"name": "rink", "type": "static", "shapes": [{"chain": {"loop": true, "points": )" +
                points + R"(}}]},
                {"name": "puck", "position": [-3, 0], "velocity": [3, 0.4], "shapes": [{"circle": {"radius": 0.2}}]}]})",
            "scene.json");
        built = build_world(scene);
        return make_camera(scene, built, kAspect);
    };
    SceneWorld built = build_world({});
    const Camera camera = camera_on_rink("[[-4, -2], [-4, 2], [4, 2], [4, -2]]", built);
    CHECK(camera.follows == BodyId{});
    CHECK(Framing(camera, kAspect).contains({-4.0, -2.0}, {4.0, 2.0}));
    const Camera on_large_rink = camera_on_rink("[[-10, -5], [-10, 5], [10, 5], [10, -5]]", built);
    CHECK(on_large_rink.follows == built.bodies.at(1).id);
    // A ball that rolls on the floor of a room sinks into it by the slop.
    const Scene rolling = parse_scene(
        R"({"format": 1, "world": {"duration": 1.5}, "bodies": [
            {"name": "room", "type": "static",
             "shapes": [{"chain": {"loop": true, "points": [[-4, -2], [-4, 2], [4, 2], [4, -2]]}}]},
            {"name": "ball", "position": [-3, -1.8], "velocity": [3, 0], "shapes": [{"circle": {"radius": 0.2}}]}]})",
        "scene.json");
    built = build_world(rolling);
    CHECK(make_camera(rolling, built, kAspect).follows == BodyId{});
}

TEST_CASE("a sensor does not count as ground, and a small static body nearby is shown whole") {
    HandMadeScene s;
    s.add_static("ground", {0.0, -0.5}, make_box({200.0f, 1.0f}));
    s.add_static("post", {3.6, 0.4}, make_box({0.4f, 0.8f}));
    const BodyId gate = s.add_static("gate", {0.0, 3.0}, make_box({4.0f, 0.5f}));
    s.built.world.remove_shape(s.built.world.shapes(gate)[0]);
    s.built.world.add_shape(gate, {.shape = make_box({4.0f, 0.5f}), .sensor = true});
    s.add_dynamic("crate", {0.0, 5.0}, make_box({3.0f, 3.0f}));
    CHECK(Framing(make_camera(s.scene, s.built, kAspect), kAspect).contains({-2.0, 0.0}, {3.8, 6.5}));
}

TEST_CASE("a frame that follows a body is five times as high as it, from the state that contains the body") {
    HandMadeScene s = pyramid({});
    s.scene.camera.follow = "late";
    const Camera before = make_camera(s.scene, s.built, kAspect);
    CHECK(Framing(before, kAspect).contains({-5.0, 0.0}, {5.0, 10.0}));
    CHECK(move_camera(before, s.scene, s.built).center == before.center);
    s.add_dynamic("late", {30.0, 4.0}, make_box({2.0f, 1.0f}));
    const Camera after = move_camera(before, s.scene, s.built);
    CHECK(after.center == DVec2{30.0, 4.0});
    // Bounds are floats, rounded outwards: at 31 m by two ulps of 2^-19 m on either side, of which the camera shows
    // five times as much.
    CHECK(near(after.height, 10.0, absolute(5.0 * 4.0 * 0x1p-19)));
    s.scene.camera.height = 6.0;
    CHECK(make_camera(s.scene, s.built, kAspect).height == 6.0);
}

TEST_CASE("a frame that follows a body without shapes is 10 m high") {
    HandMadeScene s = pyramid({});
    s.add("point", BodyType::dynamic_body, {30.0, 4.0}, {});
    s.scene.camera.follow = "point";
    const Camera camera = make_camera(s.scene, s.built, kAspect);
    CHECK(camera.center == DVec2{30.0, 4.0});
    CHECK(camera.height == 10.0);
}

TEST_CASE("a frame grows to contain what is marked, unless that is too far away") {
    HandMadeScene s;
    const BodyId near = s.add_dynamic("near", {9.0, 0.0}, make_circle(0.5f));
    const BodyId far = s.add_dynamic("far", {0.0, -500.0}, make_circle(0.5f));
    const Camera camera{{0.0, 0.0}, 8.0};
    const auto widened = [&](const Marking& marking) { return widen_camera(camera, s.built.world, marking, kAspect); };
    CHECK(widened({}).height == 8.0);
    const BodyId ground = s.add_static("ground", {0.0, -4.0}, make_box({40.0f, 1.0f}));  // some of it is in view
    CHECK(widened({.bodies = {ground}}).height == 8.0);
    CHECK(widened({.regions = {{DVec2{0.0, 0.0}, {2.0, 0.0}, {2.0, 3.0}, {0.0, 3.0}}}}).height == 8.0);
    const Framing frame(widened({.bodies = {far, near}}), kAspect);
    CHECK(frame.contains({-7.0, -4.0}, {9.5, 4.0}));
    CHECK(frame.bottom > -20.0);
    CHECK(Framing(widened({.regions = {{DVec2{0.0, 6.0}, {2.0, 6.0}, {2.0, 9.0}, {0.0, 9.0}}}}), kAspect)
              .contains({0.0, 0.0}, {2.0, 9.0}));
}

TEST_CASE("seven tenths of the room to spare are above what is shown") {
    HandMadeScene s;
    s.add_static("floor", {0.0, -0.5}, make_box({40.0f, 1.0f}));
    for (int i = 0; i < 20; ++i) s.add_dynamic("crate", {1.5 * i - 14.25, 0.5}, make_box({1.0f, 1.0f}));
    const Framing frame(make_camera(s.scene, s.built, kAspect), kAspect);
    CHECK(frame.bottom < -0.5);
    CHECK(frame.top - 1.0 > 1.5 * (0.0 - frame.bottom));
}

TEST_CASE("the frame is 1.14 times as large as what it shows, with three tenths of the room to spare below") {
    HandMadeScene s;
    s.add_static("plank", {5.0, 2.0}, make_box({8.0f, 1.0f}));
    const Camera camera = make_camera(s.scene, s.built, kAspect);
    const double height = 1.14 * 8.0 / kAspect, spare = height - 1.14 * 1.0;
    CHECK(near(camera.height, height, kFloat));
    CHECK(near(camera.center.x, 5.0, kFloat));
    CHECK(near(camera.center.y, 2.0 + 0.2 * spare, kFloat));
}

TEST_CASE("in an import the camera follows what drives away") {
    // A ball that rolls down a ramp of 60 m, in a drawing; a box that slides off a table of a R.U.B.E. export.
    const ImportedScene drawing = parse_svg(
        "<svg width='7000' height='1000'><circle id='ball' cx='120' cy='80' r='30'/>"
        "<path id='static-ramp' fill='none' stroke='black' d='M0 100 L6000 900 L7000 900'/></svg>",
        "ramp.svg");
    const ImportedScene level = parse_rube(
        R"({"gravity": {"x": 0, "y": -10}, "body": [
            {"name": "ground", "type": 0, "position": 0, "fixture": [{"polygon": {"vertices":
                {"x": [-5, 95, 95, -5], "y": [-1, -1, 0, 0]}}}]},
            {"name": "box", "type": 2, "awake": true, "position": {"x": 0, "y": 0.5}, "linearVelocity": {"x": 12, "y": 0},
             "fixture": [{"density": 1, "polygon": {"vertices": {"x": [-0.5, 0.5, 0.5, -0.5], "y": [-0.5, -0.5, 0.5, 0.5]}}}]}]})",
        "level.json");
    for (const auto& [imported, driven] : {std::pair{drawing, "ball"}, {level, "box"}}) {
        const std::string name = driven;
        CAPTURE(name);
        SceneRun run(imported.scene);
        const auto body = std::ranges::find(run.built().bodies, name, &SceneInstance::name);
        REQUIRE(body != run.built().bodies.end());
        const DVec2 start = run.world().state(body->id).pose.position;
        Camera camera = make_camera(imported.scene, run.built(), kAspect);
        for (int step = 0; step < 240; ++step) {
            run.step();
            camera = move_camera(camera, imported.scene, run.built());
            const DVec2 position = run.world().state(body->id).pose.position;
            REQUIRE(Framing(camera, kAspect).contains(position, position));
        }
        // It has left the first frame.
        CHECK(run.world().state(body->id).pose.position.x - start.x > kAspect * camera.height);
    }
}
