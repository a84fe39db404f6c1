// A scene as a Box2D world: it starts at the same poses, maps every shape, and behaves as physics predicts.
#include "reference/box2d/b2_world.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>

#include "reference/parity/parity.hpp"
#include "support/near.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_world.hpp"

using namespace tumble;
using namespace tumble::reference;
using namespace tumble::test;

namespace {

Scene scene_of(const char* bodies, const char* more = "") {
    return parse_scene(std::string(R"({"format": 1, "name": "test", "bodies": [)") + bodies + "]" + more + "}",
                       "test.json");
}

constexpr const char* kGround =
    R"({"name": "ground", "type": "static", "position": [0, -1], "shapes": [{"box": {"size": [40, 2]}}]},)";

void run(B2World& world, int steps) {
    for (int step = 0; step < steps; ++step) world.step();
}

}  // namespace

TEST_CASE("a free body falls as symplectic Euler predicts") {
    B2World world(scene_of(
        R"({"name": "ball", "position": [1, 5], "velocity": [2, 0], "shapes": [{"circle": {"radius": 0.5}}]})"));
    REQUIRE(world.body_count() == 1);
    CHECK(world.pose(0).position == DVec2{1.0, 5.0});
    run(world, 60);
    // Symplectic Euler: -g h^2 (1 + 2 + ... + 60) = -10 / 3600 * 1830. Each of 60 sums of floats up to 8 rounds by
    // 2^-22.
    CHECK(near(world.pose(0).position.x, 3.0, absolute(60 * 0x1p-22)));
    CHECK(near(world.pose(0).position.y, 5.0 - 10.0 / 3600.0 * 1830.0, absolute(60 * 0x1p-22)));
    CHECK(near(world.velocity(0).y, -10.0, float_sum(60)));
}

TEST_CASE("an off-centre shape gets the velocity of its centre of mass and turns about it") {
    B2World world(scene_of(R"({"name": "arm", "position": [0, 0], "velocity": [1, 0], "angular_velocity": 90,
                               "shapes": [{"circle": {"radius": 0.5, "center": [2, 0]}}]})",
                           R"(, "world": {"gravity": [0, 0]})"));
    CHECK(near(world.velocity(0).x, 1.0, kFloat));
    run(world, 60);
    const DVec2 center = transform_point(world.pose(0), Vec2{2.0f, 0.0f});
    CHECK(near(center.x, 3.0, absolute(60 * 0x1p-22)));
    CHECK(std::abs(center.y) < 1e-4);
}

TEST_CASE("every kind of shape comes to rest on the ground") {
    const std::string bodies = std::string(kGround) + R"(
        {"name": "circle", "position": [-6, 1], "shapes": [{"circle": {"radius": 0.5}}]},
        {"name": "capsule", "position": [-3, 1], "shapes": [{"capsule": {"from": [-0.5, 0], "to": [0.5, 0], "radius": 0.25}}]},
        {"name": "box", "position": [0, 1], "shapes": [{"box": {"size": [1, 1]}}]},
        {"name": "rounded", "position": [3, 1], "shapes": [{"box": {"size": [1, 1], "radius": 0.2}}]},
        {"name": "twelve", "position": [6, 1.5], "shapes": [{"polygon": {"vertices": [[1, 0], [0.866, 0.5], [0.5, 0.866], [0, 1],
            [-0.5, 0.866], [-0.866, 0.5], [-1, 0], [-0.866, -0.5], [-0.5, -0.866], [0, -1], [0.5, -0.866], [0.866, -0.5]]}}]})";
    B2World world(scene_of(bodies.c_str()));
    CHECK(world.notes().empty());
    run(world, 240);
    // The skin of 1 cm on each side keeps sharp polygons off the ground by up to 2 cm minus the slop.
    const double heights[] = {0.5, 0.25, 0.5, 0.5};
    for (int body = 1; body <= 4; ++body) CHECK(std::abs(world.pose(body).position.y - heights[body - 1]) < 0.025);
    // A side or a corner of the 12-gon on the ground: 0.966 or 1.
    CHECK(world.pose(5).position.y > 0.95);
    CHECK(world.pose(5).position.y < 1.03);
    CHECK(world.contact_count() >= 6);
    CHECK(world.deepest_overlap() < 0.03f);
}

TEST_CASE("distance and revolute joints keep their constraints") {
    B2World world(scene_of(
        R"({"name": "post", "type": "static", "position": [0, 4], "shapes": [{"circle": {"radius": 0.1}}]},
                              {"name": "bob", "position": [2, 4], "shapes": [{"circle": {"radius": 0.2}}]},
                              {"name": "door", "position": [1, 9], "shapes": [{"box": {"size": [2, 0.2]}}]})",
        R"(, "joints": [{"type": "distance", "bodies": ["post", "bob"], "anchors": [[0, 0], [0, 0]], "length": 2},
                                           {"type": "revolute", "bodies": ["post", "door"], "anchor": [0, 9]}])"));
    run(world, 45);
    CHECK(near(length(world.pose(1).position - DVec2{0.0, 4.0}), 2.0, absolute(1e-4)));
    CHECK(world.pose(1).position.y < 3.0);
    CHECK(length(transform_point(world.pose(2), Vec2{-1.0f, 0.0f}) - DVec2{0.0, 9.0}) < 0.02);
}

TEST_CASE("a spring oscillates about its rest length at its frequency") {
    B2World world(scene_of(
        R"({"name": "post", "type": "static", "shapes": [{"circle": {"radius": 0.1}}]},
           {"name": "bob", "position": [3.5, 0], "shapes": [{"circle": {"radius": 0.2}}]})",
        R"(, "world": {"gravity": [0, 0]}, "joints": [{"type": "distance", "bodies": ["post", "bob"],
            "anchors": [[0, 0], [0, 0]], "length": 3, "spring": {"hertz": 1}}])"));
    run(world, 30);  // half a period
    // Box2D integrates springs by the implicit Euler method, which damps them. With s = 2 pi h, a step multiplies the
    // amplitude by 1 / sqrt(1 + s^2) and advances the phase by atan(s). 30 steps round positions of 3.5 m to float.
    const double s = 2.0 * kPi / 60.0, amplitude = 0.5 * std::pow(1.0 + s * s, -15.0);
    CHECK(near(world.pose(1).position.x, 3.0 + amplitude * std::cos(30.0 * std::atan(s)), absolute(30 * 0x1p-21)));
}

TEST_CASE("bodies keep their filters, spin and sleep") {
    const std::string bodies = std::string(kGround) + R"(
        {"name": "ghost", "position": [0, 1], "angular_velocity": 90, "shapes": [{"circle": {"radius": 0.2}, "filter": {"mask": 0}}]},
        {"name": "ball", "position": [3, 0.2], "shapes": [{"circle": {"radius": 0.2}}]})";
    B2World world(scene_of(bodies.c_str()));
    CHECK(near(world.angular_velocity(1), 0.5 * kPi, kFloat));
    run(world, 120);
    CHECK(world.pose(1).position.y < -5.0);
    CHECK(world.is_awake(1));
    CHECK(!world.is_awake(2));
}

TEST_CASE("features that Box2D lacks are in the notes") {
    B2World world(
        scene_of(R"({"name": "belt", "type": "static", "shapes": [{"box": {"size": [4, 1]}, "material": "belt"}]})",
                 R"(, "materials": {"belt": {"tangent_speed": 2, "rolling_resistance": 0.1}})"));
    CHECK(world.notes().size() == 2);
}

TEST_CASE("every shipped scene runs in Box2D") {
    for (const auto& entry : std::filesystem::directory_iterator(TUMBLE_SOURCE_DIR "/scenes")) {
        if (entry.path().extension() != ".json" || entry.path().filename() == "scene.schema.json") continue;
        INFO(entry.path().filename().string());
        const Scene scene = load_scene(entry.path());
        const SceneWorld ours = build_world(scene);
        B2World world(scene);
        REQUIRE(world.body_count() == static_cast<int>(ours.bodies.size()));
        for (int body = 0; body < world.body_count(); ++body) {
            const Pose pose = ours.world.state(ours.bodies[static_cast<std::size_t>(body)].id).pose;
            CHECK(length(world.pose(body).position - pose.position) <= 1e-6 * (1.0 + length(pose.position)));
        }
        run(world, 5);
        for (int body = 0; body < world.body_count(); ++body) CHECK(is_finite(world.pose(body).position));
    }
}

TEST_SUITE("parity") {
    TEST_CASE("in the parity of every shipped scene no answer of tumble is wrong") {
        for (const auto& entry : std::filesystem::directory_iterator(TUMBLE_SOURCE_DIR "/scenes")) {
            if (entry.path().extension() != ".json" || entry.path().filename() == "scene.schema.json") continue;
            INFO(entry.path().filename().string());
            ParityOptions options;
            options.checked_first = 1000;
            const ParityResult result = run_scene_parity(load_scene(entry.path()), options, 20);
            REQUIRE(result.families.size() == 1);
            CHECK(result.families.at(0).ours_wrong == 0);
            CHECK(result.families.at(0).ours_witness_wrong == 0);
            CHECK(result.families.at(0).checked_exactly * 100 >= result.families.at(0).comparisons);
        }
    }
}
