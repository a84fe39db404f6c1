// Reading: an accepted file becomes exactly the scene that it states, and only the text itself counts.
#include <doctest/doctest.h>

#include <string>
#include <string_view>
#include <vector>

#include "scene/example.hpp"
#include "tumble/scene.hpp"
#include "tumble/scene_file.hpp"

using namespace tumble;

TEST_CASE("the example of format 1 is read in full") {
    std::vector<Diagnostic> warnings;
    const Scene scene = parse_scene(test::kExample, "example.json", &warnings);
    CHECK(warnings.empty());
    CHECK(scene.name == "seesaw");
    CHECK(scene.world.gravity == DVec2(0, -10));
    CHECK(scene.camera.height == 12.0);
    CHECK(scene.camera.follow == "ball");
    REQUIRE(scene.materials.size() == 1);
    CHECK(scene.materials.at(0).name == "ice");
    CHECK(scene.materials.at(0).density == 0.9);
    REQUIRE(scene.bodies.size() == 4);
    CHECK(scene.bodies.at(0).type == BodyType::static_body);
    CHECK(scene.bodies.at(2).angular_velocity == 90.0);
    CHECK(scene.bodies.at(2).shapes.at(0).material == "ice");
    CHECK(std::get<PyramidRepeat>(scene.bodies.at(3).repeat.value()).base == 5);
    REQUIRE(scene.joints.size() == 1);
    CHECK(scene.joints.at(0).body_b == "plank");
    CHECK(scene.joints.at(0).limits.value().upper == 20.0);
    CHECK(scene.joints.at(0).motor.value().max_torque == 50.0);
    REQUIRE(scene.timeline.size() == 2);
    CHECK(scene.timeline.at(1).spawn.value().shapes.size() == 1);
    REQUIRE(scene.expect.size() == 3);
    CHECK(scene.expect[2].inside.value().second == DVec2(1, 2));
    CHECK(scene.custom == R"({"author": "anything a user wants to keep; also on bodies, shapes and joints"})");
}

TEST_CASE("a camera may follow a body that the timeline spawns, or a copy of one that it spawns repeatedly") {
    const auto follows = [](const std::string& name) {
        return parse_scene(R"({"format": 1, "camera": {"follow": ")" + name + R"("}, "timeline": [
            {"at": 1, "spawn": {"name": "late", "shapes": [{"circle": {"radius": 1}}]}},
            {"every": 1, "spawn": {"name": "drop", "shapes": [{"circle": {"radius": 1}}]}}]})",
                           "follow.json");
    };
    CHECK(follows("late").camera.follow == "late");
    CHECK(follows("drop[3]").camera.follow == "drop[3]");
    CHECK_THROWS_AS(follows("missing"), SceneError);
}

TEST_CASE("zeros at the end of the text are judged by the text alone") {
    const auto hint_of = [](const std::string& text) {
        const std::vector<char> bytes(text.begin(), text.end());  // nothing ends it
        try {
            parse_scene(std::string_view(bytes.data(), bytes.size()), "zeros.json");
        } catch (const SceneError& error) {
            return error.diagnostics.at(0).hint;
        }
        return std::string();
    };
    const std::string before = R"({"format": )";
    CHECK(hint_of(before + "0") == "the last '{' is not closed");
    CHECK(hint_of(before + "1.0") == "the last '{' is not closed");
    CHECK(hint_of(before + "00") == "a number has no zeros before it: 0");
    CHECK(hint_of(before + "-01") == "a number has no zeros before it: 1");
}
