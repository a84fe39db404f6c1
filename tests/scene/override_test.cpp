// "--set" and "--seed": what they change, and their errors.
#include <doctest/doctest.h>

#include "scene/example.hpp"
#include "tumble/scene.hpp"
#include "tumble/scene_file.hpp"

using namespace tumble;

namespace {

Scene with(const std::vector<std::string>& overrides, const std::string& text = test::kExample) {
    return parse_scene(text, "example.json", LoadOptions{overrides, std::nullopt});
}

Diagnostic override_error(const std::string& override_text) {
    try {
        with({override_text});
    } catch (const SceneError& error) {
        REQUIRE(error.diagnostics.size() == 1);
        return error.diagnostics.at(0);
    }
    FAIL("accepted ", override_text);
    return {};
}

}  // namespace

TEST_CASE("an override replaces a value anywhere in the scene") {
    CHECK(with({"/world/gravity/1=-1.6"}).world.gravity == DVec2(0, -1.6));
    CHECK(with({"/bodies/2/shapes/0/circle/radius=0.75"}).bodies.at(2).shapes.size() == 1);
    CHECK(with({"/materials/ice/friction=0.5"}).materials.at(0).friction == 0.5);
    CHECK(with({"/bodies/3/repeat={\"ring\": {\"count\": 3}}"}).bodies.at(3).repeat->index() == 2);
    CHECK(with({"/bodies/0/name=floor", "/joints/0/bodies/0=floor"}).joints.at(0).body_a == "floor");
    CHECK(with({"/bodies/-={\"name\": \"extra\"}"}).bodies.size() == 5);
}

TEST_CASE("overrides find bodies and joints by name, and errors below them keep their pointer") {
    CHECK(with({"/bodies/ball/position/0=7"}).bodies.at(2).position.x == 7.0);
    CHECK(with({"/joints/hinge/anchor=[0, 3]"}).joints.at(0).anchor == DVec2(0, 3));
    CHECK(to_string(override_error("/bodies/ball/gravity_scale=true")) ==
          "--set /bodies/ball/gravity_scale=true: /bodies/2/gravity_scale: must be a number, got true [body]");
}

TEST_CASE("a key that the file leaves out starts from its default") {
    const Scene scene = with({"/world/gravity/1=-1.6", "/camera/center=[1, 2]", "/name=moon"}, R"({"format": 1})");
    CHECK(scene.world.gravity == DVec2(0, -1.6));
    CHECK(scene.world.substeps == 4);
    CHECK(scene.camera.center == DVec2(1, 2));
    CHECK(scene.name == "moon");
    CHECK(with({"/bodies/1/velocity=[1, 0]"}).bodies.at(1).velocity == DVec2(1, 0));
}

TEST_CASE("the later of two overrides takes effect, and the seed is applied last") {
    CHECK(with({"/world/seed=3", "/world/seed=4"}).world.seed == 4);
    CHECK(parse_scene(test::kExample, "", LoadOptions{{"/world/seed=3"}, 9}).world.seed == 9);
    CHECK(parse_scene(R"({"format": 1})", "", LoadOptions{{}, 18446744073709551615u}).world.seed ==
          18446744073709551615u);
}

TEST_CASE("an override whose pointer leads nowhere is an error that names the step") {
    CHECK(to_string(override_error("/world/substeps=0")) ==
          "--set /world/substeps=0: /world/substeps: must be at least 1, got 0 [world]");
    CHECK(to_string(override_error("/world/substep=8")) ==
          "--set /world/substep=8: /world/substep: unknown key \"substep\" [world]\n  hint: did you mean 'substeps'?");
    CHECK(override_error("/bodies/9/name=x").message == "step 2, '9', is neither an index nor a name in an array of 4");
    const Diagnostic misspelt = override_error("/bodies/bal/position=[0, 0]");
    CHECK(misspelt.message == "step 2, 'bal', is neither an index nor a name in an array of 4");
    CHECK(misspelt.hint == "did you mean 'ball'?");
    CHECK(override_error("/wrold/seed=1").hint == "did you mean 'world'?");
    CHECK(override_error("/name/x=1").message ==
          "step 2, 'x', is below a value that is neither an object nor an array");
    CHECK(override_error("/world/gravity/1=down").message == "must be a number, got \"down\"");
    for (const char* text : {"world/seed=1", "/world/seed", "=1", ""})
        CHECK(override_error(text).message == "must read /json/pointer=value");
}

TEST_CASE("a deeply nested override value is an error, not a crash") {
    CHECK(override_error("/custom/a/b=1").message == "step 2, 'a', does not exist");
    CHECK(override_error("/world/gravity=" + std::string(100000, '[')).pointer == "/world/gravity");
}

TEST_CASE("replace_text changes one string and leaves the rest of the text") {
    const std::string text =
        "\xEF\xBB\xBF{ // note\n \"format\": 1, \"name\": \"a \\\"b\\\"\", \"custom\": [\"x\", 2]}";
    CHECK(replace_text(text, "/name", "c") ==
          "\xEF\xBB\xBF{ // note\n \"format\": 1, \"name\": \"c\", \"custom\": [\"x\", 2]}");
    CHECK(replace_text(text, "/custom/0", "y\"").find("[\"y\\\"\", 2]") != std::string::npos);
    CHECK_THROWS_AS(replace_text(text, "/custom/1", "y"), std::invalid_argument);
    CHECK_THROWS_AS(replace_text(text, "/format", "y"), std::invalid_argument);
}
