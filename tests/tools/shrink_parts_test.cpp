// The parts of a scene, and when two failures are the same.
#include <doctest/doctest.h>

#include <string>

#include "tools/shrink/failure.hpp"
#include "tools/shrink/scene_parts.hpp"
#include "tumble/scene_file.hpp"

using namespace tumble;
using namespace tumble::tools;

namespace {

SceneJson document(const std::string& text) { return document_of(parse_scene(text, "test")); }

constexpr const char* kBall = R"("shapes": [{"circle": {"radius": 0.5}}])";

// A hub with so many balls on ropes, an event, a claim and a camera that name it, and others that do not.
std::string hub_scene(int balls) {
    const std::string ball = kBall;
    std::string bodies = R"({"name": "hub", )" + ball + "}", joints;
    for (int i = 0; i < balls; ++i) {
        const std::string name = "ball" + std::to_string(i);
        bodies += R"(, {"name": ")" + name + R"(", "position": [)" + std::to_string(i + 2) + ", 0], " + ball + "}";
        joints += (i == 0 ? "" : ", ") + std::string(R"({"type": "distance", "bodies": ["hub", ")") + name +
                  R"("], "anchors": [[0, 0], [0, 0]]})";
    }
    return R"({"format": 1, "camera": {"follow": "hub", "height": 9}, "materials": {"ice": {"friction": 0}},
      "bodies": [)" +
           bodies + R"(], "joints": [)" + joints + R"(], "timeline": [
      {"at": 1, "body": "hub", "impulse": [1, 0]}, {"when": "ball0.x > hub.x", "despawn": "ball1"},
      {"at": 2, "body": "ball0", "impulse": [1, 0]}],
      "expect": [{"that": "hub.x < 3"}, {"body": "ball0", "height": [0, 1]}]})";
}

}  // namespace

TEST_CASE("what names a removed body goes with it, also if the loader does not report all of it at once") {
    for (const int balls : {2, 50}) {
        const SceneJson scene = document(hub_scene(balls));
        SceneJson smaller = without(scene, {Pointer("/bodies/0")});
        const std::optional<std::string> text = repaired_text(smaller);
        REQUIRE(text);
        const SceneJson repaired = SceneJson::parse(*text);
        CHECK(repaired["bodies"].size() == static_cast<std::size_t>(balls));
        CHECK_FALSE(repaired.contains("joints"));
        REQUIRE(repaired["timeline"].size() == 1);
        CHECK(repaired["timeline"][0]["body"] == "ball0");
        REQUIRE(repaired["expect"].size() == 1);
        CHECK(repaired["expect"][0]["body"] == "ball0");
        CHECK(repaired["camera"] == SceneJson{{"height", 9}});
        CHECK_FALSE(valid_text(without(scene, {Pointer("/bodies/0")})));
    }
}

TEST_CASE("parts are removed by their first indices, whatever else is removed") {
    const SceneJson scene = document(hub_scene(12));
    const SceneJson rest = without(scene, {Pointer("/joints/2"), Pointer("/joints/9"), Pointer("/joints/10")});
    REQUIRE(rest["joints"].size() == 9);
    CHECK(rest["joints"][2]["bodies"][1] == "ball3");
    CHECK(rest["joints"][7]["bodies"][1] == "ball8");
    CHECK(rest["joints"][8]["bodies"][1] == "ball11");
}

TEST_CASE("single copies have the names and poses of the repeated body") {
    const Scene scene = parse_scene(R"({"format": 1, "bodies": [
      {"name": "first", "shapes": [{"circle": {"radius": 1}}]},
      {"name": "crate", "position": [3, 4], "angle": 30, "repeat": {"grid": {"columns": 2, "rows": 2, "spacing": [2, 5]}},
       "shapes": [{"circle": {"radius": 0.5}}]},
      {"name": "last", "shapes": [{"circle": {"radius": 1}}]}]})",
                                    "test");
    const SceneJson single = with_single_copies(document_of(scene), scene, 1);
    REQUIRE(single["bodies"].size() == 6);
    CHECK(single["bodies"][5]["name"] == "last");
    const double places[4][2] = {{3, 4}, {5, 4}, {3, 9}, {5, 9}};
    for (std::size_t i = 0; i < 4; ++i) {
        const SceneJson& crate = single["bodies"][i + 1];
        CHECK(crate["name"] == "crate[" + std::to_string(i) + "]");
        CHECK(crate["position"][0] == places[i][0]);
        CHECK(crate["position"][1] == places[i][1]);
        CHECK(crate["angle"] == 30);
        CHECK_FALSE(crate.contains("repeat"));
    }
    CHECK(valid_text(single));
}

TEST_CASE("numbers are rounded to significant digits, but never coarser than to a whole number") {
    CHECK(rounded(12.347, 1) == 12.0);
    CHECK(rounded(12.347, 3) == 12.3);
    CHECK(rounded(-137.25, 1) == -137.0);
    CHECK(rounded(0.0312, 1) == 0.03);
    CHECK(rounded(-0.0312, 2) == -0.031);
    CHECK(rounded(0.96, 1) == 1.0);
    CHECK(rounded(9.99, 2) == 10.0);
    CHECK(rounded(0.1, 1) == 0.1);
    CHECK(rounded(0.0, 1) == 0.0);
}

TEST_CASE("numbers of a finding are masked, those of names are not") {
    CHECK(with_masked_numbers("its height is -0.31 m") == "its height is # m");
    CHECK(with_masked_numbers("'n5' and body[12] overlap by 1.5e-05 m at [1, -2.5]") ==
          "'n5' and body[#] overlap by # m at [#, #]");
    CHECK(with_masked_numbers("'crate[3]': it is at [4, 5e]") == "'crate[#]': it is at [#, #e]");
    CHECK(with_masked_numbers("a_2.x is inf, step 30: v3") == "a_2.x is inf, step #: v3");
}

TEST_CASE("a failure has the side on which a value is out of bounds") {
    SceneExpectation inside;
    inside.inside = SceneBox{{0.0, 0.0}, {2.0, 3.0}};
    CHECK(side_of(inside, "it is at [2.5, 0.5]") == ", on the right");
    CHECK(side_of(inside, "'crate[4]': it is at [-1, -0.5]") == ", on the left");
    CHECK(side_of(inside, "it is at [2.5, 9]") == ", above");
    CHECK(side_of(inside, "it is at [1, -9]") == ", below");
    CHECK(side_of(inside, "it does not exist").empty());
    SceneExpectation height;
    height.height = SceneInterval{1.0, 2.0};
    CHECK(side_of(height, "its height is 2.5 m") == ", above");
    CHECK(side_of(height, "'a is 7': its height is 0.5 m") == ", below");
    SceneExpectation count;
    count.event_count = SceneInterval{0.0, 3.0};
    CHECK(side_of(count, "there were 4") == ", above");
    SceneExpectation touches;
    touches.touches = "b";
    CHECK(side_of(touches, "the gap is 3 m").empty());
}

TEST_CASE("failures of a scene are its failed claims in their order, without those that any other scene fails") {
    const Scene scene = parse_scene(
        R"({"format": 1, "world": {"duration": 1}, "bodies": [{"name": "a", )" + std::string(kBall) + R"(}], "expect": [
      {"state_hash": "0123456789abcdef"}, {"body": "a", "height": [-9, 9]}, {"body": "a", "height": [0, 9]},
      {"body": "a", "speed": [0, 5], "when": "always"}]})",
        "test");
    const std::vector<Failure> failures = find_failures(scene, false);
    REQUIRE(failures.size() == 2);
    CHECK(failures[0].claim == 2);
    CHECK(failures[0].step == 60);
    CHECK(failures[0].text == "the height of 'a' is between 0 and 9 m at the end: its height is # m, below");
    CHECK(failures[1].claim == 3);
    CHECK(failures[1].text == "the speed of 'a' is between 0 and 5 m/s always: its speed is # m/s, above");
}
