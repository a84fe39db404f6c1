// Scenes that include scenes: poses, names and claims of the parts.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "included_files.hpp"
#include "tumble/scene_run.hpp"
#include "tumble/scene_world.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

// A part with everything that has a position, a direction, an angle or a name.
const std::string kPart = scene_text(R"(
    "world": {"gravity": [0, 5], "duration": 1}, "camera": {"center": [9, 9]},
    "materials": {"rubber": {"friction": 0.9}},
    "bodies": [
        {"name": "hub", "position": [1, 2], "angle": 20, "velocity": [3, -1], "angular_velocity": 7,
         "shapes": [{"box": {"size": [2, 1], "center": [0.5, 0], "angle": 15}, "material": "rubber"}]},
        {"name": "arm", "position": [4, 2], "shapes": [{"circle": {"radius": 0.5}}]},
        {"name": "row", "type": "static", "position": [0, -3], "angle": 5,
         "repeat": {"grid": {"columns": 2, "rows": 2, "spacing": [2, 1]}}, "shapes": [{"circle": {"radius": 0.2}}]},
        {"name": "slider", "position": [2, -3], "velocity": [1, 0], "shapes": [{"circle": {"radius": 0.1}}]}
    ],
    "joints": [
        {"type": "revolute", "name": "hinge", "bodies": ["hub", "arm"], "anchor": [2, 2]},
        {"type": "prismatic", "name": "rail", "bodies": ["row[0]", "arm"], "anchor": [2, 2], "axis": [1, 0]},
        {"type": "prismatic", "name": "own_rail", "bodies": ["row[1]", "slider"], "anchors": [[0, 0], [0, 0]], "axis": [1, 0]},
        {"type": "mouse", "name": "pull", "bodies": ["row[0]", "hub"], "anchor": [1, 2], "max_force": 100},
        {"type": "pulley", "name": "rope", "bodies": ["hub", "slider"], "anchors": [[0, 0], [0, 0]], "ground_anchors": [[1, 9], [2, 8]]},
        {"type": "gear", "joints": ["hinge", "own_rail"], "ratio": 2}
    ],
    "timeline": [
        {"at": 0.1, "body": "arm", "impulse": [2, 0]},
        {"at": 0.2, "joint": "pull", "target": [5, 6]},
        {"at": 0.3, "gravity": [0, -1]},
        {"at": 0.4, "spawn": {"name": "drop", "position": [0, 1], "velocity": [0, -2], "shapes": [{"circle": {"radius": 0.1}, "material": "rubber"}]}},
        {"at": 0.5, "release": "rail"},
        {"at": 0.6, "despawn": "drop"}
    ],
    "expect": [
        {"body": "hub", "inside": [[0, 1], [2, 3]], "at": 0},
        {"body": "hub", "angle": [19, 21], "at": 0},
        {"body": "slider", "count": [1, 1], "region": [[1.9, -3.1], [2.1, -2.9]], "at": 0},
        {"joint": "hinge", "max_joint_error": 0.1},
        {"body": "hub", "never_touches": "row[1]"},
        {"at_rest_by": 1}, {"max_penetration": 0.1}, {"max_energy_gain": 1000}
    ])");

// Position (10, -4), turned by 90 degrees: the point (x, y) becomes (10 - y, -4 + x), the vector (x, y) (-y, x).
const Files kTurnedPart = {
    {"parts/arm.json", kPart},
    {"main.json", includes(R"({"file": "parts/arm.json", "position": [10, -4], "angle": 90, "prefix": "left/"})")}};

const SceneBody& body_of(const Scene& scene, const std::string& name) {
    for (const SceneBody& body : scene.bodies)
        if (body.name == name) return body;
    FAIL("there is no body " << name);
    return scene.bodies.front();
}

}  // namespace

TEST_CASE("a part rotated by 90 degrees has the poses of hand arithmetic, exactly") {
    const Scene scene = load(kTurnedPart);
    REQUIRE(scene.bodies.size() == 4);
    const SceneBody& hub = scene.bodies.at(0);
    CHECK(hub.name == "left/hub");
    CHECK(hub.position == DVec2(8, -3));
    CHECK(hub.angle == 110);
    CHECK(hub.velocity == DVec2(1, 3));
    CHECK(hub.angular_velocity == 7);
    CHECK(hub.shapes.at(0).material == "left/rubber");
    CHECK(std::get<BoxGeometry>(hub.shapes.at(0).geometry).center == DVec2(0.5, 0));  // body coordinates
    CHECK(scene.joints.at(0).name == "left/hinge");
    CHECK(scene.joints.at(0).body_b == "left/arm");
    CHECK(*scene.joints.at(0).anchor == DVec2(8, -2));
    CHECK(*scene.joints.at(1).axis == DVec2(0, 1));
    CHECK(*scene.joints.at(2).axis == DVec2(1, 0));  // coordinates of its first body, as its anchors
    CHECK(scene.joints.at(4).ground_anchors->first == DVec2(1, -3));
    CHECK(scene.joints.at(4).ground_anchors->second == DVec2(2, -2));
    CHECK(scene.joints.at(5).joint_a == "left/hinge");
    CHECK(scene.joints.at(5).joint_b == "left/own_rail");
    CHECK(*scene.timeline.at(0).impulse == DVec2(0, 2));
    CHECK(*scene.timeline.at(1).target == DVec2(4, 1));
    CHECK(scene.timeline.at(2).spawn->name == "left/drop");
    CHECK(scene.timeline.at(2).spawn->position == DVec2(9, -4));
    CHECK(scene.timeline.at(2).spawn->velocity == DVec2(2, 0));
    CHECK(scene.timeline.at(3).release == "left/rail");
    CHECK(scene.timeline.at(4).despawn == "left/drop");
    CHECK(scene.materials.at(0).name == "left/rubber");
}

TEST_CASE("the world settings of an included part are ignored") {
    const Scene scene = load(kTurnedPart);
    CHECK(scene.world.gravity == DVec2(0, -10));
    CHECK(scene.world.duration == 5);
    CHECK(!scene.camera.center);
    CHECK(scene.timeline.size() == 5);  // of 6: gravity
    CHECK(scene.expect.size() == 5);    // of 8: claims of the whole world
    CHECK(scene.include.empty());
}

TEST_CASE("the copies of a repeated body turn with the part") {
    // The grid starts at (0, -3): (13, -4) in the scene; its columns go up, its rows to the left.
    const SceneWorld built = build_world(load(kTurnedPart));
    REQUIRE(built.bodies.size() == 7);
    const DVec2 expected[] = {{13, -4}, {13, -2}, {12, -4}, {12, -2}};
    for (std::size_t copy = 0; copy < 4; ++copy) {
        CHECK(built.bodies[2 + copy].name == "left/row[" + std::to_string(copy) + "]");
        CHECK(built.world.state(built.bodies[2 + copy].id).pose.position == expected[copy]);
        CHECK(built.world.state(built.bodies[2 + copy].id).pose.rotation == make_rotation_degrees(95));
    }
}

TEST_CASE("a part at any angle moves as it does alone, seen from its frame") {
    // Without gravity a turned part moves as an upright one.
    Files files = {
        {"part.json", kPart},
        {"main.json",
         scene_text(
             R"("world": {"gravity": [0, 0]}, "include": [{"file": "part.json", "position": [3, 8], "angle": 37}])")}};
    const Scene placed = load(files);
    files["main.json"] = scene_text(R"("world": {"gravity": [0, 0]}, "include": [{"file": "part.json"}])");
    const Scene alone = load(files);
    SceneRun a(alone), b(placed);
    constexpr double kRounding = 1e-4;  // m, of float velocities and rotations over the steps
    for (int step = 0; step < 60; ++step) {
        a.step();
        b.step();
        REQUIRE(a.built().bodies.size() == b.built().bodies.size());
        for (std::size_t i = 0; i < a.built().bodies.size(); ++i) {
            if (!a.world().is_valid(a.built().bodies[i].id)) continue;
            const DVec2 p = a.world().state(a.built().bodies[i].id).pose.position;
            const double c = std::cos(37 * kPi / 180), s = std::sin(37 * kPi / 180);
            const DVec2 there(3 + c * p.x - s * p.y, 8 + s * p.x + c * p.y);
            CHECK_MESSAGE(length(b.world().state(b.built().bodies[i].id).pose.position - there) < kRounding, step, " ",
                          b.built().bodies[i].name);
        }
    }
}

TEST_CASE("claims of a part are measured in its frame") {
    for (const double angle : {0.0, 90.0, 37.0, -120.0}) {
        Files files = kTurnedPart;
        files["main.json"] = scene_text(
            R"("world": {"gravity": [0, 0], "duration": 0.1}, "include": [{"file": "parts/arm.json", "position": [10, -4], "angle": )" +
            std::to_string(angle) + "}]");
        const Scene scene = load(files);
        SceneRun run(scene);
        ExpectationWatch watch(scene, run.built());
        watch.observe(run.built());
        const std::vector<ExpectationResult> results = watch.results();
        REQUIRE(results.size() == 5);
        for (const std::size_t of_place : {0u, 1u, 2u})
            CHECK_MESSAGE(results[of_place].passed, results[of_place].claim);
    }
}

TEST_CASE("a frame moves and turns what a claim measures") {
    // The ball is at (3, 4); seen from a frame at (1, 4) turned by 90 degrees it is at (0, -2), and its angle is -60.
    const std::string start =
        R"("world": {"gravity": [0, 0]}, "bodies": [{"name": "ball", "position": [3, 4], "angle": 30, "shapes": [{"circle": {"radius": 0.1}}]}], "expect": [{"body": "ball", "at": 0, "frame": {"position": [1, 4], "angle": 90}, )";
    struct Case {
        const char* claim;
        bool holds;
    };
    for (const Case& c : {Case{R"("inside": [[-0.1, -2.1], [0.1, -1.9]])", true},
                          {R"("inside": [[2.9, 3.9], [3.1, 4.1]])", false},
                          {R"("outside": [[2.9, 3.9], [3.1, 4.1]])", true},
                          {R"("height": [-2.1, -1.9])", true},
                          {R"("height": [3.9, 4.1])", false},
                          {R"("angle": [-60.1, -59.9])", true},
                          {R"("angle": [29.9, 30.1])", false},
                          {R"("count": [1, 1], "region": [[-0.1, -2.1], [0.1, -1.9]])", true},
                          {R"("count": [1, 1], "region": [[2.9, 3.9], [3.1, 4.1]])", false}}) {
        const Scene scene = parse_scene(scene_text(start + c.claim + "}]"), "claim.json");
        SceneRun run(scene);
        ExpectationWatch watch(scene, run.built());
        watch.observe(run.built());
        CHECK_MESSAGE(watch.results()[0].passed == c.holds, c.claim);
        CHECK(watch.results()[0].claim.find("in the frame at [1, 4] turned by 90 degrees") != std::string::npos);
    }
}

TEST_CASE("one file can be included twice, and the scene's own joints reach both") {
    const Scene scene = load({{"parts/arm.json", kPart}, {"main.json", scene_text(R"(
            "include": [{"file": "parts/arm.json", "prefix": "a/"}, {"file": "parts/arm.json", "position": [20, 0], "prefix": "b/"}],
            "bodies": [{"name": "hub"}],
            "joints": [{"type": "weld", "bodies": ["a/arm", "b/row[3]"], "anchor": [0, 0]}])")}});
    CHECK(scene.bodies.size() == 9);
    CHECK(scene.bodies.at(0).name == "hub");  // its own come first
    CHECK(scene.joints.size() == 13);
    CHECK(body_of(scene, "b/hub").position == DVec2(21, 2));
    CHECK(build_world(scene).joints.size() == 13);
}

TEST_CASE("includes nest: poses and prefixes combine") {
    // wheel at (1, 0) in the axle; the axle at (2, 0), turned by 90, in the car; the car at (0, 5): wheel at (2, 6).
    const Files files = {
        {"main.json", includes(R"({"file": "cars/car.json", "position": [0, 5], "prefix": "car/"})")},
        {"cars/car.json",
         includes(R"({"file": "parts/axle.json", "position": [2, 0], "angle": 90, "prefix": "front/"})")},
        {"cars/parts/axle.json", scene_text(R"("bodies": [{"name": "wheel", "position": [1, 0], "angle": 10}])")}};
    const Scene scene = load(files);
    REQUIRE(scene.bodies.size() == 1);
    CHECK(scene.bodies.at(0).name == "car/front/wheel");
    CHECK(scene.bodies.at(0).position == DVec2(2, 6));
    CHECK(scene.bodies.at(0).angle == 100);
}

TEST_CASE("a scene is written with its includes, or with their contents, and is the same world") {
    LoadOptions as_written = with_files(kTurnedPart);
    as_written.keep_includes = true;
    const std::string& text = kTurnedPart.at("main.json");
    const Scene written = parse_scene(text, "main.json", as_written);
    CHECK(written.bodies.empty());
    REQUIRE(written.include.size() == 1);
    CHECK(parse_scene(to_json(written), "main.json", as_written).include.at(0).position == DVec2(10, -4));
    CHECK_THROWS_AS(build_world(written), SceneError);
    const Scene whole = load(kTurnedPart);
    const Scene again = parse_scene(to_json(written), "main.json", with_files(kTurnedPart));
    const Scene flat = parse_scene(to_json(whole), "flat.json");
    for (const Scene* scene : {&again, &flat}) {
        CHECK(scene_hash(*scene) == scene_hash(whole));
        SceneRun run(*scene), reference(whole);
        for (int step = 0; step < 30; ++step) {
            CHECK(run.world().state_hash() == reference.world().state_hash());
            run.step();
            reference.step();
        }
    }
}

TEST_CASE("a scene file includes from its own folder, and is written as it was") {
    const std::filesystem::path file = std::filesystem::path(TUMBLE_SOURCE_DIR) / "scenes/convoy.json";
    const Scene scene = load_scene(file);
    CHECK(scene.bodies.size() == 10);
    CHECK(scene.include.empty());
    LoadOptions as_written;
    as_written.keep_includes = true;
    CHECK(to_json(load_scene(file, as_written)) == read_file(file, 1 << 20));
}

TEST_CASE("equal materials of several files are one") {
    const std::string with_material = scene_text(R"("materials": {"m": {"friction": 0.1}})");
    const Scene scene = load({{"a.json", with_material},
                              {"b.json", with_material},
                              {"main.json", includes(R"({"file": "a.json"}, {"file": "b.json"})")}});
    CHECK(scene.materials.size() == 1);
}
