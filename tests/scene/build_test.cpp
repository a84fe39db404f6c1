// From a scene to a world: every number arrives, once, and saving a scene changes no bit of its simulation.
#include <doctest/doctest.h>

#include <cmath>

#include "scene/example.hpp"
#include "scene/reread.hpp"
#include "scene/shipped.hpp"
#include "support/near.hpp"
#include "tumble/scene.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_world.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

std::uint64_t hash_after(const Scene& scene, int steps) {
    SceneWorld built = build_world(scene);
    for (int step = 0; step < steps; ++step) built.world.step();
    return built.world.state_hash();
}

}  // namespace

TEST_CASE("the example becomes a world with names, copies and a joint") {
    const Scene scene = parse_scene(test::kExample, "");
    const SceneWorld built = build_world(scene);
    REQUIRE(built.bodies.size() == 3 + 15);  // a pyramid of base 5 has 15 crates
    CHECK(built.world.bodies().size() == 18);
    CHECK(built.bodies.at(2).name == "ball");
    CHECK(built.bodies.at(3).name == "crate[0]");
    CHECK(built.bodies.at(17).name == "crate[14]");
    CHECK(built.bodies.at(17).source == 3);
    REQUIRE(built.joints.size() == 1);
    const auto& hinge = std::get<RevoluteJointDef>(built.world.joint(built.joints.at(0).id));
    CHECK(hinge.body_a == built.bodies.at(0).id);
    CHECK(hinge.anchor_a == Vec2{0, 1.5f});  // the ground's origin is at (0, -0.5)
    CHECK(hinge.anchor_b == Vec2{0, 0});
}

TEST_CASE("angles become radians, and materials and poses are those of the scene") {
    const SceneWorld built = build_world(parse_scene(test::kExample, ""));
    const BodyState ball = built.world.state(built.bodies.at(2).id);
    CHECK(ball.pose.position == DVec2(3, 6));
    CHECK(ball.pose.rotation == make_rotation_degrees(30));
    CHECK(ball.angular_velocity == static_cast<float>(kPi / 2));
    const ShapeId shape = built.world.shapes(built.bodies.at(2).id)[0];
    CHECK(built.world.material(shape) == SurfaceMaterial{0.9f, 0.02f, 0.1f, 0.0f, 0.0f});
    CHECK(near(built.world.mass(built.bodies.at(2).id).mass, 0.9 * kPi * 0.25, kFloat));
    CHECK(built.world.type(built.bodies.at(0).id) == BodyType::static_body);
    CHECK(built.world.def().gravity == Vec2{0, -10});
}

TEST_CASE("a box of a body is turned by its angle in degrees") {
    const SceneWorld built = build_world(
        parse_scene(R"({"format": 1, "bodies": [{"shapes": [{"box": {"size": [4, 2], "angle": 90}}]}]})", "box.json"));
    REQUIRE(built.bodies.size() == 1);
    REQUIRE(built.world.shapes(built.bodies.at(0).id).size() == 1);
    const Shape& shape = built.world.shape(built.world.shapes(built.bodies.at(0).id)[0]);
    for (int i = 0; i < shape.vertex_count(); ++i) {
        CHECK(near(std::abs(shape.vertex(i).x), 1.0, kFloat));
        CHECK(near(std::abs(shape.vertex(i).y), 2.0, kFloat));
    }
}

TEST_CASE("sleep flags, filters and sensors are those of the scene") {
    const SceneWorld built = build_world(parse_scene(R"({"format": 1, "world": {"sleeping": false, "continuous": false},
        "bodies": [{"awake": false, "shapes": [{"circle": {"radius": 1}, "sensor": true},
                                               {"circle": {"radius": 1}, "filter": {"category": 4, "mask": 6, "group": -2}},
                                               {"circle": {"radius": 1}, "filter": {}}]}]})",
                                                     ""));
    const World& world = built.world;
    CHECK_FALSE(world.def().sleeping);
    CHECK_FALSE(world.def().continuous);
    CHECK_FALSE(world.is_awake(built.bodies.at(0).id));
    const std::span<const ShapeId> shapes = world.shapes(built.bodies.at(0).id);
    REQUIRE(shapes.size() == 3);
    CHECK(world.is_sensor(shapes[0]));
    CHECK_FALSE(world.is_sensor(shapes[1]));
    CHECK(world.filter(shapes[0]) == CollisionFilter{});
    CHECK(world.filter(shapes[1]) == CollisionFilter{4, 6, -2});
    CHECK(may_touch(world.filter(shapes[2]), CollisionFilter{}));
    CHECK(near(world.mass(built.bodies.at(0).id).mass, 2.0 * kPi, kFloat));
}

TEST_CASE("locks, a stated mass and whether a body is enabled are those of the scene") {
    const SceneWorld built = build_world(parse_scene(R"({"format": 1, "bodies": [
        {"fixed_rotation": true, "lock_y": true, "allow_sleep": false, "allow_fast_rotation": true,
         "mass": {"mass": 3, "center": [0.5, 0], "inertia": 2}, "shapes": [{"circle": {"radius": 1}}]},
        {"enabled": false, "velocity": [1, 0], "shapes": [{"circle": {"radius": 1}}]}]})",
                                                     ""));
    const BodyDef def = built.world.definition(built.bodies.at(0).id);
    CHECK(def.locks == BodyLocks{.x = false, .y = true, .rotation = true});
    CHECK_FALSE(def.allow_sleep);
    CHECK(def.allow_fast_rotation);
    CHECK(built.world.mass(built.bodies.at(0).id) == BodyMass{3.0f, {0.5f, 0.0f}, 2.0f});
    CHECK(built.world.is_enabled(built.bodies.at(0).id));
    CHECK_FALSE(built.world.is_enabled(built.bodies.at(1).id));
}

TEST_CASE("a joint's world anchor becomes local to turned and shifted bodies") {
    const Scene scene = parse_scene(R"({"format": 1,
        "bodies": [{"name": "a", "position": [5, 0], "angle": 90, "shapes": [{"circle": {"radius": 1}}]},
                   {"name": "b", "position": [5, 4], "angle": 540, "shapes": [{"circle": {"radius": 1}}]}],
        "joints": [{"type": "revolute", "bodies": ["a", "b"], "anchor": [5, 3]},
                   {"type": "distance", "bodies": ["a", "b"], "anchors": [[1, 0], [0, 0]]}]})",
                                    "");
    const SceneWorld built = build_world(scene);
    // a is turned by +90 degrees: up in the world is +x of a; b by 180: up is -y.
    const auto& hinge = std::get<RevoluteJointDef>(built.world.joint(built.joints.at(0).id));
    CHECK(hinge.anchor_a == Vec2{3, 0});
    CHECK(hinge.anchor_b == Vec2{0, 1});
    CHECK(hinge.reference_angle == static_cast<float>(kPi / 2));  // 540 - 90 = 450, of which a whole turn is left out
    // a's anchor is at (5, 1) in the world, b's at (5, 4).
    CHECK(std::get<DistanceJointDef>(built.world.joint(built.joints.at(1).id)).length == 3.0f);
}

TEST_CASE("saving and loading gives the same world, bit for bit, before and after steps") {
    for (const std::filesystem::path& file : test::shipped_scenes()) {
        if (file.stem() == "large_pyramid") continue;  // the same kinds of things as pyramid, 25 times as many
        CAPTURE(file);
        const Scene scene = load_scene(file);
        CHECK(hash_after(scene, 0) == hash_after(reread(scene), 0));
        CHECK(hash_after(scene, 60) == hash_after(reread(scene), 60));
    }
    CHECK(hash_after(parse_scene(test::kExample, ""), 60) == hash_after(reread(parse_scene(test::kExample, "")), 60));
}

TEST_CASE("the seed changes a scattered world") {
    const std::filesystem::path file = std::filesystem::path(TUMBLE_SOURCE_DIR) / "scenes/capsule_pile.json";
    CHECK(hash_after(load_scene(file), 0) != hash_after(load_scene(file, LoadOptions{{}, 99}), 0));
}

TEST_CASE("negative zeros are zeros, in files and in scenes made by a program") {
    Scene scene;
    scene.bodies.emplace_back();
    const std::uint64_t zero = hash_after(scene, 0);
    scene.bodies.at(0).position.x = -0.0;
    scene.bodies.at(0).velocity.y = -0.0;
    CHECK(hash_after(scene, 0) == zero);
    CHECK(hash_after(parse_scene(R"({"format": 1, "bodies": [{"position": [-0, -0.0]}]})", ""), 0) == zero);
}

TEST_CASE("a concave outline becomes several shapes of one body with the whole area") {
    // An L of 3 x 3 with a 2 x 2 notch: area 5.
    const Scene scene = parse_scene(R"({"format": 1, "bodies": [{"shapes": [
        {"outline": {"points": [[0, 0], [3, 0], [3, 1], [1, 1], [1, 3], [0, 3]]}}]}]})",
                                    "");
    const SceneWorld built = build_world(scene);
    CHECK(built.world.shapes(built.bodies.at(0).id).size() == 2);
    CHECK(near(built.world.mass(built.bodies.at(0).id).mass, 5.0, kFloat));
}

TEST_CASE("a scene made by a program is validated as a file is") {
    Scene scene;
    scene.name = "made";
    scene.bodies.emplace_back();
    scene.bodies.at(0).shapes.push_back({CircleGeometry{-1, {}}, "glass", ""});
    scene.joints.emplace_back();
    try {
        build_world(scene);
        FAIL("built");
    } catch (const SceneError& error) {
        REQUIRE(error.diagnostics.size() >= 3);
        CHECK(error.diagnostics.at(0).file == "made");
        CHECK(error.diagnostics.at(0).line == 0);
        CHECK(error.diagnostics.at(0).pointer == "/bodies/0/shapes/0/circle");
        CHECK(error.diagnostics.at(1).message == "there is no material \"glass\"");
    }
    scene = {};
    scene.bodies.emplace_back();
    scene.bodies.at(0).position.x = NAN;
    CHECK_THROWS_AS(build_world(scene), SceneError);
    scene.bodies.at(0).position.x = 0;
    scene.world.substeps = 0;
    CHECK_THROWS_AS(build_world(scene), SceneError);
}

TEST_CASE("the segments of a chain become neighbours, open on the right of its direction or on both sides") {
    const auto falls_to = [](const std::string& chain, double from, double speed) {
        const Scene scene = parse_scene(R"({"format": 1, "bodies": [
            {"type": "static", "shapes": [{"chain": )" +
                                            chain + R"(, "material": "ice"}]},
            {"position": [-4, )" + std::to_string(from) +
                                            R"(], "velocity": [)" + std::to_string(speed) + R"(, 0],
             "shapes": [{"box": {"size": [0.5, 0.5]}, "material": "ice"}]}],
            "materials": {"ice": {"friction": 0}}})",
                                        "");
        SceneWorld built = build_world(scene);
        for (int step = 0; step < 60; ++step) built.world.step();
        return built.world.state(built.bodies.at(1).id).pose;
    };
    const std::string points = R"([[9, 0], [4.3, 0], [2, 0], [0.1, 0], [-1.9, 0], [-3.1, 0], [-9, 0]])";
    const std::string one_sided = "{\"points\": " + points + "}",
                      two_sided = "{\"points\": " + points + ", \"two_sided\": true}";
    const Pose slid = falls_to(one_sided, 0.25, 8.0);  // its right is up
    CHECK(near(slid.position.x, 4.0, kFloat));
    CHECK(near(slid.position.y, 0.25, absolute(1e-4)));
    CHECK(std::abs(slid.rotation.s) < 1e-3f);
    CHECK(near(falls_to(two_sided, 0.25, 8.0).position.x, 4.0, kFloat));
    const std::string reversed = R"({"points": [[-9, 0], [0.1, 0], [9, 0]]})";
    CHECK(falls_to(reversed, 0.25, 0.0).position.y < -1.0);
    CHECK(falls_to(R"({"points": [[-9, 0], [0.1, 0], [9, 0]], "two_sided": true})", 0.25, 0.0).position.y > 0.2);
}
