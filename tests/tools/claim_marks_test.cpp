// The marks in the picture of a claim: its region in world coordinates, and its bodies.
#include "tools/claims/claim_marks.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "tumble/scene_file.hpp"

using namespace tumble;
using namespace tumble::tools;

namespace {

// Two crates fall beside a ball that rests on the ground.
SceneWorld made() {
    return build_world(parse_scene(R"({"format": 1, "bodies": [
        {"name": "ground", "type": "static", "shapes": [{"box": {"size": [20, 1], "center": [0, -0.5]}}]},
        {"name": "ball", "position": [4, 0.4], "shapes": [{"circle": {"radius": 0.5}}]},
        {"name": "crate", "position": [0, 3], "repeat": {"grid": {"columns": 2}}, "shapes": [{"box": {"size": [1, 1]}}]}]})",
                                   "marks.json"));
}

bool marks(const Marking& marking, const SceneWorld& built, const std::string& name) {
    const auto found = std::ranges::find(built.bodies, name, &SceneInstance::name);
    return found != built.bodies.end() && std::ranges::count(marking.bodies, found->id) == 1;
}

}  // namespace

TEST_CASE("an `inside` claim marks its box and its body") {
    const SceneWorld built = made();
    SceneExpectation claim;
    claim.body = "ball";
    claim.inside = SceneBox{{0.0, 0.0}, {2.0, 1.0}};
    claim.frame = SceneFrame{{10.0, 5.0}, 90.0};
    const Marking marking = marks_of(claim, {false, "'ball' is inside", "it is not"}, built);
    REQUIRE(marking.regions.size() == 1);
    CHECK(marking.regions[0][0] == DVec2{10.0, 5.0});
    CHECK(marking.regions[0][1] == DVec2{10.0, 7.0});  // along the frame's x, which points up
    CHECK(marking.regions[0][2] == DVec2{9.0, 7.0});
    CHECK(marking.bodies.size() == 1);
    CHECK(marks(marking, built, "ball"));
    CHECK(marking.caption == std::vector<std::string>{"expected that 'ball' is inside", "it is not"});
}

TEST_CASE("a `touches` claim marks both bodies, and all copies of a common name") {
    const SceneWorld built = made();
    SceneExpectation claim;
    claim.body = "ball";
    claim.touches = "crate";
    const Marking marking = marks_of(claim, {}, built);
    CHECK(marking.bodies.size() == 3);
    CHECK(marks(marking, built, "crate[0]"));
    CHECK(marks(marking, built, "crate[1]"));
}

TEST_CASE("a `that` claim marks the bodies in its conditions, each once") {
    const SceneWorld built = made();
    SceneExpectation claim;
    claim.that = "ball.x < crate[1].x and ball.y > 1";
    claim.before = "ball.speed > 2";
    const Marking marking = marks_of(claim, {}, built);
    CHECK(marking.bodies.size() == 2);
    CHECK(marks(marking, built, "ball"));
    CHECK(marks(marking, built, "crate[1]"));
}

TEST_CASE("claims of the world mark the bodies that violate them") {
    SceneWorld built = made();
    for (int step = 0; step < 10; ++step) built.world.step();
    SceneExpectation rest;
    rest.at_rest_by = 1.0;
    const Marking awake = marks_of(rest, {}, built);
    CHECK(awake.bodies.size() == 3);
    SceneExpectation overlap;
    overlap.max_penetration = 0.01;
    const Marking deepest = marks_of(overlap, {}, built);
    CHECK(deepest.bodies.size() == 2);
    CHECK(marks(deepest, built, "ball"));
    CHECK(marks(deepest, built, "ground"));
}
