#include "tumble/scene_run.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <utility>

using namespace tumble;

namespace {

// A disc of mass pi / 4 kg (radius 0.5 m, density 1) in space, and what the scene says besides.
Scene make_scene(const std::string& more) {
    return parse_scene(R"({"format": 1, "world": {"gravity": [0, 0], "duration": 2},
        "bodies": [{"name": "disc", "shapes": [{"circle": {"radius": 0.5}}]}], )" +
                           more + "}",
                       "");
}

// Speed of the disc after so many steps.
float speed_after(const Scene& scene, int steps) {
    SceneRun run(scene);
    for (int i = 0; i < steps; ++i) run.step();
    return run.world().state(run.built().bodies[0].id).velocity.x;
}

ExpectationResult judge(const Scene& scene, int steps) {
    SceneRun run(scene);
    ExpectationWatch watch(scene, run.built());
    watch.observe(run.built());
    for (int i = 0; i < steps; ++i) {
        run.step();
        watch.observe(run.built());
    }
    return watch.results().at(0);
}

constexpr float kMass = 0.785398f;

}  // namespace

TEST_CASE("an impulse happens before the first step that begins at its time or later") {
    const Scene scene = make_scene(R"("timeline": [{"at": 0.51, "body": "disc", "impulse": [2, 0]}])");
    // Step 30 begins at 0.5 s, step 31 at 0.5167 s: it shows after 32 steps, and never again.
    CHECK(speed_after(scene, 31) == 0.0f);
    CHECK(speed_after(scene, 32) == doctest::Approx(2.0f / kMass).epsilon(1e-5));
    CHECK(speed_after(scene, 100) == speed_after(scene, 32));
    const Scene at_start = make_scene(R"("timeline": [{"at": 0, "body": "disc", "impulse": [2, 0]}])");
    CHECK(speed_after(at_start, 1) == doctest::Approx(2.0f / kMass).epsilon(1e-5));
}

TEST_CASE("an impulse that repeats happens at 0, every, 2 every ... up to until") {
    const Scene scene =
        make_scene(R"("timeline": [{"every": 0.1, "until": 0.3, "body": "disc", "impulse": [1, 0]}])");
    // At 0, 6, 12 and 18 steps.
    CHECK(speed_after(scene, 6) == doctest::Approx(1.0f / kMass).epsilon(1e-5));
    CHECK(speed_after(scene, 7) == doctest::Approx(2.0f / kMass).epsilon(1e-5));
    CHECK(speed_after(scene, 19) == doctest::Approx(4.0f / kMass).epsilon(1e-5));
    CHECK(speed_after(scene, 120) == doctest::Approx(4.0f / kMass).epsilon(1e-5));
    CHECK_THROWS_AS(make_scene(R"("timeline": [{"every": 0.01, "body": "disc", "impulse": [1, 0]}])"), SceneError);
}

TEST_CASE("an impulse acts on the centre of mass: the body does not turn") {
    const Scene scene = parse_scene(R"({"format": 1, "world": {"gravity": [0, 0]},
        "bodies": [{"name": "club", "angle": 30, "shapes": [{"box": {"size": [1, 1], "center": [3, 1]}}]}],
        "timeline": [{"at": 0, "body": "club", "impulse": [0, 5]}]})",
                                    "");
    SceneRun run(scene);
    run.step();
    const BodyState state = run.world().state(run.built().bodies[0].id);
    CHECK(state.velocity.y == doctest::Approx(5.0f).epsilon(1e-5));
    CHECK(std::abs(state.angular_velocity) < 1e-5f);
}

TEST_CASE("at rest: from a time on nothing is faster than what may fall asleep") {
    CHECK(judge(make_scene(R"("expect": [{"at_rest_by": 1}])"), 120).passed);
    const Scene kicked = make_scene(
        R"("expect": [{"at_rest_by": 1}], "timeline": [{"at": 1.5, "body": "disc", "impulse": [1, 0]}])");
    const ExpectationResult moved = judge(kicked, 120);
    CHECK_FALSE(moved.passed);
    CHECK(moved.step == 91);
    CHECK(moved.finding == "'disc' moves at 1.27 m/s");
    CHECK(judge(kicked, 90).passed);
    // 0.06 m/s is too fast; 0.04 m/s is not, but a rim of 0.5 m that turns at 0.04 rad/s adds 0.02 m/s.
    const char* const drifting = R"({"format": 1, "world": {"gravity": [0, 0], "sleeping": false}, "bodies":
        [{"name": "disc", "velocity": [0.04, 0], "angular_velocity": TURN, "shapes": [{"circle": {"radius": 0.5}}]}],
        "expect": [{"at_rest_by": 0}]})";
    for (const auto& [turn, passes] : {std::pair{"0", true}, std::pair{"2.3", false}}) {
        std::string text = drifting;
        CHECK(judge(parse_scene(text.replace(text.find("TURN"), 4, turn), ""), 10).passed == passes);
    }
}

TEST_CASE("a depth is judged by the deepest overlap of the run") {
    const std::string bodies = R"({"format": 1, "world": {"gravity": [0, 0]}, "bodies": [
        {"name": "wall", "type": "static", "shapes": [{"box": {"size": [1, 4]}}]},
        {"name": "disc", "position": [0.9, 0], "shapes": [{"circle": {"radius": 0.5}}]}], "expect": [)";
    const ExpectationResult deep = judge(parse_scene(bodies + R"({"max_penetration": 0.05}]})", ""), 60);
    CHECK_FALSE(deep.passed);
    CHECK(deep.step == 1);
    CHECK(deep.finding.starts_with("'wall' and 'disc' overlap by 0.1 m at [0.45, "));
    CHECK(judge(parse_scene(bodies + R"({"max_penetration": 0.11}]})", ""), 60).passed);
}

TEST_CASE("a place is looked at at its time, or at the end; what is never reached has failed") {
    const std::string kick = R"("timeline": [{"at": 0, "body": "disc", "impulse": [0.785398, 0]}], "expect": [)";
    // 1 m/s: at 0.5 m after half a second, at 1.5 m at the end.
    CHECK(judge(make_scene(kick + R"({"body": "disc", "inside": [[0.49, -1], [0.51, 1]], "at": 0.5}])"), 90).passed);
    CHECK(judge(make_scene(kick + R"({"body": "disc", "inside": [[1.49, -1], [1.51, 1]]}])"), 90).passed);
    const ExpectationResult missed = judge(make_scene(kick + R"({"body": "disc", "inside": [[0, 0.1], [9, 1]]}])"), 90);
    CHECK_FALSE(missed.passed);
    CHECK(missed.finding == "it is at [1.5, 0]");
    CHECK(missed.step == 90);
    const ExpectationResult never = judge(make_scene(kick + R"({"body": "disc", "inside": [[-9, -9], [9, 9]], "at": 2}])"), 90);
    CHECK_FALSE(never.passed);
    CHECK(never.finding == "the run ends before that");
}
