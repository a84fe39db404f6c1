// Claims: for each kind a run for which it holds, and a similar one for which it fails.
#include "tumble/scene_run.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <utility>

#include "scene/disc_scene.hpp"
#include "scene/judge.hpp"

using namespace tumble;
using test::judge;
using test::make_disc_scene;

TEST_CASE("an at_rest_by claim holds if from its time on no body is faster than the limit of sleep") {
    CHECK(judge(make_disc_scene(R"("expect": [{"at_rest_by": 1}])"), 120).passed);
    const Scene kicked = make_disc_scene(
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

TEST_CASE("the speed limit of rest depends on the scale of the world, as that of sleep does") {
    // The root of 1/25 is 1/5: 0.05 m/s becomes 0.01 m/s.
    for (const auto& [scale, passes] : {std::pair{"1", true}, std::pair{"0.04", false}}) {
        std::string text = R"({"format": 1, "world": {"gravity": [0, 0], "sleeping": false, "scale": SCALE}, "bodies":
            [{"name": "disc", "velocity": [0.02, 0], "shapes": [{"circle": {"radius": 0.1}}]}], "expect": [{"at_rest_by": 0}]})";
        CHECK(judge(parse_scene(text.replace(text.find("SCALE"), 5, scale), ""), 10).passed == passes);
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

TEST_CASE("a position is evaluated at its time or at the end; a time that the run never reaches fails the claim") {
    const std::string kick = R"("timeline": [{"at": 0, "body": "disc", "impulse": [0.785398, 0]}], "expect": [)";
    // 1 m/s: at 0.5 m after half a second, at 1.5 m at the end.
    CHECK(
        judge(make_disc_scene(kick + R"({"body": "disc", "inside": [[0.49, -1], [0.51, 1]], "at": 0.5}])"), 90).passed);
    CHECK(judge(make_disc_scene(kick + R"({"body": "disc", "inside": [[1.49, -1], [1.51, 1]]}])"), 90).passed);
    const ExpectationResult missed =
        judge(make_disc_scene(kick + R"({"body": "disc", "inside": [[0, 0.1], [9, 1]]}])"), 90);
    CHECK_FALSE(missed.passed);
    CHECK(missed.finding == "it is at [1.5, 0]");
    CHECK(missed.step == 90);
    const ExpectationResult never =
        judge(make_disc_scene(kick + R"({"body": "disc", "inside": [[-9, -9], [9, 9]], "at": 2}])"), 90);
    CHECK_FALSE(never.passed);
    CHECK(never.finding == "the run ends before that");
    CHECK(never.step == 90);
    CHECK(never.time == 1.5);
}

TEST_CASE("a position can be claimed always, sometime, within a time span, and outside a box") {
    // 1 m/s from the origin: inside the box from 0.5 s to 1 s.
    const std::string kick = R"("timeline": [{"at": 0, "body": "disc", "impulse": [0.785398, 0]}], "expect": [)";
    const std::string box = R"("body": "disc", "inside": [[0.5, -1], [1, 1]])",
                      not_box = R"("body": "disc", "outside": [[0.5, -1], [1, 1]])";
    CHECK(judge(make_disc_scene(kick + "{" + box + R"(, "when": "sometime"}])"), 120).passed);
    CHECK_FALSE(judge(make_disc_scene(kick + "{" + box + R"(, "when": "always"}])"), 120).passed);
    CHECK(
        judge(make_disc_scene(kick + "{" + box + R"(, "when": "always", "from": 0.52, "until": 0.98}])"), 120).passed);
    CHECK_FALSE(judge(make_disc_scene(kick + "{" + box + R"(, "when": "sometime", "from": 1.1}])"), 120).passed);
    CHECK_FALSE(judge(make_disc_scene(kick + "{" + not_box + R"(, "when": "always"}])"), 120).passed);
    CHECK(judge(make_disc_scene(kick + "{" + not_box + R"(, "when": "always", "from": 1.02}])"), 120).passed);
    CHECK(judge(make_disc_scene(kick + "{" + not_box + "}]"), 120).passed);
    // At the end the disc is at (2, 0): outside a box beyond it on any side, inside one about it.
    for (const char* beyond : {"[[1, 1], [3, 2]]", "[[1, -2], [3, -1]]", "[[3, -1], [4, 1]]", "[[0, -1], [1, 1]]"})
        CHECK(judge(make_disc_scene(kick + R"({"body": "disc", "outside": )" + beyond + "}]"), 120).passed);
    CHECK_FALSE(judge(make_disc_scene(kick + R"({"body": "disc", "outside": [[1, -1], [3, 1]]}])"), 120).passed);
    // The state farthest outside the box decides: that of the end, at 2 m.
    const ExpectationResult worst =
        judge(make_disc_scene(kick + R"({"body": "disc", "inside": [[0, -1], [1, 1]], "when": "always"}])"), 120);
    CHECK_FALSE(worst.passed);
    CHECK(worst.step == 120);
    CHECK(worst.finding == "it is at [2, 0]");
}

TEST_CASE("height, speed and angle lie between bounds") {
    // Free fall for 1 s at -10 m/s^2: 10 m/s, 5 m deep. 90 degrees/s: a quarter turn.
    const auto falling = [](const std::string& claim) {
        return judge(
            parse_scene(
                R"({"format": 1, "bodies": [{"name": "disc", "angular_velocity": 90, "shapes": [{"circle": {"radius": 0.5}}]}],
            "expect": [)" +
                    claim + "]}",
                ""),
            60);
    };
    CHECK(falling(R"({"body": "disc", "height": [-5.001, -4.999], "at": 1})").passed);
    CHECK_FALSE(falling(R"({"body": "disc", "height": [-4.999, 0], "at": 1})").passed);
    CHECK(falling(R"({"body": "disc", "speed": [9.999, 10.001]})").passed);
    CHECK_FALSE(falling(R"({"body": "disc", "speed": [0, 9], "when": "always"})").passed);
    CHECK(falling(R"({"body": "disc", "angle": [89.9, 90.1]})").passed);
    CHECK(falling(R"({"body": "disc", "angle": [45, 46], "when": "sometime"})").passed);
    const ExpectationResult slow = falling(R"({"body": "disc", "speed": [0, 5], "when": "always"})");
    CHECK(slow.finding == "its speed is 10 m/s");
    CHECK(slow.step == 60);
}

TEST_CASE("touching is detected by contacts and sensors, for the bodies of the claim alone") {
    const auto judged = [](const std::string& claim, const char* sensor) {
        return judge(parse_scene(R"({"format": 1, "world": {"gravity": [0, 0]}, "bodies": [
            {"name": "ball", "velocity": [4, 0], "shapes": [{"circle": {"radius": 0.5}}]},
            {"name": "wall", "type": "static", "position": [3, 0], "shapes": [{"box": {"size": [1, 4]}, "sensor": )" +
                                     std::string(sensor) + R"(}]},
            {"name": "other", "type": "static", "position": [0, 9], "shapes": [{"box": {"size": [1, 1]}}]}], "expect": [)" +
                                     claim + "]}",
                                 ""),
                     60);
    };
    for (const char* const sensor : {"false", "true"}) {
        CAPTURE(sensor);
        CHECK(judged(R"({"body": "ball", "touches": "wall"})", sensor).passed);
        CHECK(judged(R"({"body": "wall", "touches": "ball"})", sensor).passed);
        CHECK_FALSE(judged(R"({"body": "ball", "never_touches": "wall"})", sensor).passed);
        CHECK_FALSE(judged(R"({"body": "ball", "touches": "other"})", sensor).passed);
        CHECK(judged(R"({"body": "ball", "never_touches": "other"})", sensor).passed);
        // The ball crosses the gap of 2 m in half a second.
        CHECK(judged(R"({"body": "ball", "never_touches": "wall", "until": 0.4})", sensor).passed);
        CHECK_FALSE(judged(R"({"body": "ball", "touches": "wall", "until": 0.4})", sensor).passed);
    }
    const ExpectationResult hit = judged(R"({"body": "ball", "never_touches": "wall"})", "false");
    CHECK(hit.finding == "they touch");
    CHECK((hit.step >= 29 && hit.step <= 31));
    // At 0.4 s it has covered 1.6 m of the 2 m.
    const ExpectationResult missed = judged(R"({"body": "ball", "touches": "wall", "until": 0.4})", "false");
    CHECK(missed.finding == "they are 0.4 m apart");
    CHECK(missed.step == 24);
}

TEST_CASE("a body that crosses a thin sensor within a step touches it in that step") {
    // From 3.33 m to 5 m in the third step; the gate is from 4.15 m to 4.2 m.
    const auto shot = [](const std::string& claim) {
        return judge(parse_scene(R"({"format": 1, "world": {"gravity": [0, 0]}, "bodies": [
            {"name": "ball", "velocity": [100, 0], "shapes": [{"circle": {"radius": 0.1}}]},
            {"name": "gate", "type": "static", "position": [4.175, 0], "shapes": [{"box": {"size": [0.05, 4]}, "sensor": true}]}],
            "expect": [)" + claim + "]}",
                                 ""),
                     60);
    };
    CHECK(shot(R"({"body": "ball", "touches": "gate"})").passed);
    const ExpectationResult passed = shot(R"({"body": "ball", "never_touches": "gate"})");
    CHECK_FALSE(passed.passed);
    CHECK(passed.step == 3);
    CHECK(passed.finding == "they touch");
}

TEST_CASE("a missed touch of a sensor reports the gap, one of a body that is never spawned that it does not exist") {
    const std::string scene = R"({"format": 1, "world": {"gravity": [0, 0]}, "bodies": [
        {"name": "ball", "velocity": [4, 0], "shapes": [{"circle": {"radius": 0.5}}]},
        {"name": "gate", "type": "static", "position": [9, 0], "shapes": [{"box": {"size": [1, 4]}, "sensor": true}]}],
        "timeline": [{"at": 8, "spawn": {"name": "late", "shapes": [{"circle": {"radius": 1}}]}}], "expect": [)";
    // A gap of 8 m, of which it has covered 4 m after a second.
    CHECK(judge(parse_scene(scene + R"({"body": "ball", "touches": "gate"}]})", ""), 60).finding ==
          "they are 4 m apart");
    CHECK(judge(parse_scene(scene + R"({"body": "ball", "touches": "late"}]})", ""), 60).finding ==
          "'late' does not exist");
}

TEST_CASE("a claim on the common name of copies must hold for every copy, a touch for any") {
    // Copies at x = 0, 3 and 6 m; each falls for a second by 5 m and a little, the ball hits the middle one at once.
    const auto fall = [](const std::string& claim) {
        return judge(parse_scene(R"({"format": 1, "bodies": [
            {"name": "ball", "type": "kinematic", "position": [3, 0.9], "shapes": [{"circle": {"radius": 0.5}}]},
            {"name": "drop", "repeat": {"grid": {"columns": 3, "spacing": [3, 1]}}, "shapes": [{"circle": {"radius": 0.5}}]}],
            "timeline": [{"every": 0.25, "from": 0.5, "spawn": {"name": "late", "position": [20, 0], "shapes": [{"circle": {"radius": 0.5}}]}}],
            "expect": [)" + claim + "]}",
                                 ""),
                     60);
    };
    CHECK(fall(R"({"body": "drop", "height": [-9, 1], "when": "always"})").passed);
    const ExpectationResult outside = fall(R"({"body": "drop", "inside": [[-1, -9], [4, 9]]})");
    CHECK_FALSE(outside.passed);
    CHECK(outside.finding.starts_with("'drop[2]': it is at [6, "));
    CHECK(fall(R"({"body": "ball", "touches": "drop"})").passed);
    CHECK(fall(R"({"body": "drop", "touches": "ball"})").passed);
    const ExpectationResult hit = fall(R"({"body": "drop", "never_touches": "ball"})");
    CHECK_FALSE(hit.passed);
    CHECK(hit.finding == "'ball' and 'drop[1]' touch");
    CHECK(fall(R"({"body": "drop", "never_touches": "drop"})").passed);
    // States before the first copy do not count; without any copy the claim fails.
    CHECK(fall(R"({"body": "late", "inside": [[19, -9], [21, 1]], "when": "always"})").passed);
    CHECK_FALSE(fall(R"({"body": "late", "height": [-0.1, 1], "when": "always"})").passed);
    const ExpectationResult never = fall(R"({"body": "late", "height": [-9, 1], "when": "always", "until": 0.4})");
    CHECK_FALSE(never.passed);
    CHECK(never.finding == "no copy ever exists");
}

TEST_CASE("a claim reads as a sentence") {
    const auto text = [](const std::string& claim) {
        return judge(make_disc_scene("\"expect\": [" + claim + "]"), 1).claim;
    };
    CHECK(text(R"({"event_count": [1, 1], "event": "sensor_begin"})") == "exactly 1 'sensor_begin' happens by the end");
    CHECK(text(R"({"event_count": [2, 3], "event": "contact_end", "body": "disc", "at": 2})") ==
          "between 2 and 3 'contact_end' of 'disc' happen by 2 s");
    CHECK(text(R"({"count": [0, 0], "region": [[0, 0], [1, 1]]})") ==
          "exactly 0 bodies are in [0, 0] to [1, 1] at the end");
    CHECK(text(R"({"body": "disc", "height": [1, 2]})") == "the height of 'disc' is between 1 and 2 m at the end");
    CHECK(text(R"({"body": "disc", "angle": [0, 0]})") == "the angle of 'disc' is 0 degrees at the end");
}

TEST_CASE("bodies are counted in a region, and events up to a time") {
    const auto count = [](const std::string& claim) {
        return judge(
            parse_scene(
                R"({"format": 1, "bodies": [{"type": "static", "position": [0, -0.5], "shapes": [{"box": {"size": [90, 1]}}]},
            {"name": "crate", "position": [0, 0.5], "repeat": {"grid": {"columns": 3, "spacing": [3, 1]}}, "shapes": [{"box": {"size": [1, 1]}}]},
            {"name": "ball", "position": [20, 5], "shapes": [{"circle": {"radius": 0.5}}]}], "expect": [)" +
                    claim + "]}",
                ""),
            90);
    };
    CHECK(count(R"({"count": [3, 3], "region": [[-1, 0], [7, 1]]})").passed);
    CHECK(count(R"({"count": [4, 4], "region": [[-1, 0], [30, 9]]})").passed);
    CHECK(count(R"({"count": [3, 3], "body": "crate", "region": [[-1, 0], [30, 9]]})").passed);
    CHECK_FALSE(count(R"({"count": [4, 4], "body": "crate", "region": [[-1, 0], [30, 9]]})").passed);
    CHECK(count(R"({"count": [2, 2], "region": [[2, 0], [7, 1]]})").passed);
    CHECK(count(R"({"event_count": [4, 4], "event": "contact_begin"})").passed);
    CHECK(
        count(R"({"event_count": [3, 3], "event": "contact_begin", "at": 0.5})").passed);  // the ball falls for 0.95 s
    CHECK(count(R"({"event_count": [1, 1], "event": "contact_begin", "body": "ball"})").passed);
    CHECK(count(R"({"event_count": [0, 0], "event": "joint_broke"})").passed);
    const ExpectationResult wrong = count(R"({"event_count": [9, 9], "event": "contact_begin"})");
    CHECK_FALSE(wrong.passed);
    CHECK(wrong.finding == "there were 4");
}

TEST_CASE("a count of broken joints is of all bodies, or of those of one body") {
    // Balls of 31 g, 0.31 N, on a rod that breaks at 0.2 N and on one that does not break.
    const auto hang = [](const std::string& claim) {
        return judge(parse_scene(R"({"format": 1, "bodies": [{"name": "roof", "type": "static"},
            {"name": "weak", "position": [0, -1], "shapes": [{"circle": {"radius": 0.1}}]},
            {"name": "strong", "position": [1, -1], "shapes": [{"circle": {"radius": 0.1}}]}],
            "joints": [{"type": "distance", "bodies": ["roof", "weak"], "anchors": [[0, 0], [0, 0]], "break_force": 0.2},
                       {"type": "distance", "bodies": ["roof", "strong"], "anchors": [[1, 0], [0, 0]]}],
            "world": {"duration": 0.5}, "expect": [)" +
                                     claim + "]}",
                                 "hang.json"),
                     30);
    };
    CHECK(hang(R"({"event_count": [1, 1], "event": "joint_broke"})").passed);
    CHECK(hang(R"({"event_count": [1, 1], "event": "joint_broke", "body": "weak"})").passed);
    CHECK(hang(R"({"event_count": [0, 0], "event": "joint_broke", "body": "strong"})").passed);
    CHECK(hang(R"({"event_count": [1, 1], "event": "joint_broke", "body": "roof"})").passed);
}

TEST_CASE("claims on joint errors, energy and the state hash hold or fail as the run decides") {
    const auto swing = [](const std::string& claim, const std::string& more = "") {
        return judge(parse_scene(R"({"format": 1, "bodies": [{"name": "pivot", "type": "static"},
            {"name": "bob", "position": [1, 0], "shapes": [{"circle": {"radius": 0.2}}]}],
            "joints": [{"type": "revolute", "name": "hinge", "bodies": ["pivot", "bob"], "anchor": [0, 0]}], )" +
                                     more + R"("expect": [)" + claim + "]}",
                                 ""),
                     60);
    };
    CHECK(swing(R"({"max_joint_error": 0.01})").passed);
    CHECK(swing(R"({"max_joint_error": 0.01, "joint": "hinge"})").passed);
    // 1000 N on 0.126 kg open the soft hinge by more than F / (m w^2), w = 2 pi 60: 56 mm, and more as it swings
    // faster.
    const ExpectationResult torn =
        swing(R"({"max_joint_error": 0.01})", R"("timeline": [{"at": 0, "body": "bob", "force": [0, -1000]}], )");
    CHECK_FALSE(torn.passed);
    CHECK(torn.finding.starts_with("the anchors of 'hinge' are "));
    CHECK(swing(R"({"max_energy_gain": 0.01})").passed);
    const ExpectationResult hash = swing(R"({"state_hash": "0000000000000000"})");
    CHECK_FALSE(hash.passed);
    CHECK(swing(R"({"state_hash": ")" + hash.finding.substr(6) + R"("})").passed);
}

TEST_CASE("a claim on energy does not count the work of the timeline as gain") {
    const auto judge_disc = [](const std::string& claim, const std::string& timeline) {
        return judge(make_disc_scene(R"("timeline": [)" + timeline + R"(], "expect": [)" + claim + "]"), 120);
    };
    const char* const claim = R"({"max_energy_gain": 1e-4})";
    CHECK(judge_disc(claim, R"({"at": 0, "body": "disc", "impulse": [2, 0]})").passed);
    CHECK(judge_disc(claim, R"({"at": 0.5, "body": "disc", "velocity": [0, 9]})").passed);
    CHECK(judge_disc(claim, R"({"at": 0.5, "body": "disc", "torque": 3, "until": 1})").passed);
    CHECK(judge_disc(claim, R"({"at": 1, "spawn": {"name": "b", "velocity": [5, 0], "position": [0, 9],
                                "shapes": [{"circle": {"radius": 0.5}}]}})")
              .passed);
    // A force of 2 N over the displacement of the disc in a second, 2 / (2 m) m, minus an error of the order of a step.
    const ExpectationResult pushed =
        judge_disc(R"({"max_energy_gain": 0.05})", R"({"at": 0, "body": "disc", "force": [2, 0], "until": 1})");
    CHECK_MESSAGE(pushed.passed, pushed.finding);
    // What the program does between the steps is no work of the timeline: 1 / (2 m) J by an impulse of 1 N s.
    const Scene scene = make_disc_scene(R"("expect": [{"max_energy_gain": 0.6}, {"max_energy_gain": 0.6, "from": 1}])");
    SceneRun run(scene);
    ExpectationWatch watch(scene, run.built());
    watch.observe(run.built());
    run.world().apply_impulse(run.built().bodies[0].id, {1.0f, 0.0f});
    for (int i = 0; i < 120; ++i) {
        run.step();
        watch.observe(run.built());
    }
    CHECK_FALSE(watch.results()[0].passed);
    CHECK(watch.results()[0].finding == "the energy is 0.637 J above that of the start");
    CHECK(watch.results()[1].passed);
}

TEST_CASE("a claim on the time of a step holds within its limit") {
    CHECK(judge(make_disc_scene(R"("expect": [{"max_ms_per_step": 1000}])"), 30).passed);
    const ExpectationResult slow = judge(make_disc_scene(R"("expect": [{"max_ms_per_step": 1e-9}])"), 30);
    CHECK_FALSE(slow.passed);
    CHECK(slow.finding.starts_with("a step takes "));
}

TEST_CASE("a watch does not decide claims that need frames or another scene") {
    const ExpectationResult picture = judge(make_disc_scene(R"("expect": [{"picture": "golden.png"}])"), 1);
    CHECK_FALSE(picture.is_decided);
    CHECK_FALSE(
        judge(make_disc_scene(R"("expect": [{"max_time_ratio": 2, "reference": "other.json"}])"), 1).is_decided);
    CHECK(judge(make_disc_scene(R"("expect": [{"at_rest_by": 0}])"), 1).is_decided);
}
