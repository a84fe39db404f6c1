// What happens in a run, and when.
#include "tumble/scene_run.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "scene/disc_scene.hpp"
#include "support/near.hpp"

using namespace tumble;
using namespace tumble::test;
using test::make_disc_scene;

namespace {

// Speed of the disc after so many steps.
float speed_after(const Scene& scene, int steps) {
    SceneRun run(scene);
    for (int i = 0; i < steps; ++i) run.step();
    return run.world().state(run.built().bodies.at(0).id).velocity.x;
}

constexpr float kMass = 0.785398f;

}  // namespace

TEST_CASE("an impulse happens before the first step that begins at its time or later") {
    const Scene scene = make_disc_scene(R"("timeline": [{"at": 0.51, "body": "disc", "impulse": [2, 0]}])");
    // Step 30 begins at 0.5 s, step 31 at 0.5167 s: it shows after 32 steps, and never again.
    CHECK(speed_after(scene, 31) == 0.0f);
    CHECK(near(speed_after(scene, 32), 2.0f / kMass, kFloat));
    CHECK(speed_after(scene, 100) == speed_after(scene, 32));
    const Scene at_start = make_disc_scene(R"("timeline": [{"at": 0, "body": "disc", "impulse": [2, 0]}])");
    CHECK(near(speed_after(at_start, 1), 2.0f / kMass, kFloat));
}

TEST_CASE("a repeated event begins at its time and keeps its period") {
    const Scene scene = make_disc_scene(
        R"("timeline": [{"every": 0.1, "from": 0.25, "until": 0.4, "body": "disc", "impulse": [1, 0]}])");
    // At 15 and 21 steps; 27 is past the end.
    for (const auto& [steps, impulses] : {std::pair{15, 0}, {16, 1}, {21, 1}, {22, 2}, {100, 2}})
        CHECK(near(speed_after(scene, steps), static_cast<float>(impulses) / kMass, kFloat));
}

TEST_CASE("an impulse that repeats happens at 0, every, 2 every ... up to until") {
    const Scene scene =
        make_disc_scene(R"("timeline": [{"every": 0.1, "until": 0.3, "body": "disc", "impulse": [1, 0]}])");
    // At 0, 6, 12 and 18 steps.
    CHECK(near(speed_after(scene, 6), 1.0f / kMass, kFloat));
    CHECK(near(speed_after(scene, 7), 2.0f / kMass, kFloat));
    CHECK(near(speed_after(scene, 19), 4.0f / kMass, kFloat));
    CHECK(near(speed_after(scene, 120), 4.0f / kMass, kFloat));
    CHECK_THROWS_AS(make_disc_scene(R"("timeline": [{"every": 0.01, "body": "disc", "impulse": [1, 0]}])"), SceneError);
}

TEST_CASE("an impulse acts on the centre of mass: the body does not turn") {
    const Scene scene = parse_scene(R"({"format": 1, "world": {"gravity": [0, 0]},
        "bodies": [{"name": "club", "angle": 30, "shapes": [{"box": {"size": [1, 1], "center": [3, 1]}}]}],
        "timeline": [{"at": 0, "body": "club", "impulse": [0, 5]}]})",
                                    "");
    SceneRun run(scene);
    run.step();
    const BodyState state = run.world().state(run.built().bodies.at(0).id);
    CHECK(near(state.velocity.y, 5.0f, kFloat));
    CHECK(std::abs(state.angular_velocity) < 1e-5f);
}

TEST_CASE("a force acts in each step from its time until its end, and an angular impulse turns") {
    // 2 N for 0.5 s: 1 N s.
    const Scene pushed = make_disc_scene(R"("timeline": [{"at": 0.5, "until": 1, "body": "disc", "force": [2, 0]}])");
    CHECK(speed_after(pushed, 30) == 0.0f);
    CHECK(near(speed_after(pushed, 45), 0.5f / kMass, float_sum(180)));
    CHECK(near(speed_after(pushed, 90), 1.0f / kMass, float_sum(360)));
    // I = m r^2 / 2 = 0.0981748 kg m^2.
    for (const char* const event : {R"({"at": 0, "body": "disc", "angular_impulse": 0.1})",
                                    R"({"at": 0, "until": 0.5, "body": "disc", "torque": 0.2})"}) {
        SceneRun run(make_disc_scene(std::string(R"("timeline": [)") + event + "]"));
        for (int i = 0; i < 60; ++i) run.step();
        CHECK(near(run.world().state(run.built().bodies.at(0).id).angular_velocity, 0.1 / 0.0981748, float_sum(240)));
    }
}

TEST_CASE("velocities and gravity are set") {
    CHECK(speed_after(make_disc_scene(R"("timeline": [{"at": 0.5, "body": "disc", "velocity": [3, 0]}])"), 40) == 3.0f);
    SceneRun run(make_disc_scene(
        R"("timeline": [{"at": 0.5, "gravity": [4, 0]}, {"at": 0, "body": "disc", "angular_velocity": 90}])"));
    for (int i = 0; i < 90; ++i) run.step();
    const BodyState state = run.world().state(run.built().bodies.at(0).id);
    CHECK(near(state.velocity.x, 4.0f, float_sum(240)));  // for a second
    CHECK(near(state.angular_velocity, kPi / 2, kFloat));
}

TEST_CASE("spawned bodies have their names, events act on them, and despawned bodies are removed") {
    const Scene scene = make_disc_scene(R"("timeline": [
        {"every": 0.25, "until": 0.5, "spawn": {"name": "drop", "position": [5, 0], "velocity": [1, 0], "shapes": [{"circle": {"radius": 0.1}}]}},
        {"at": 0.5, "spawn": {"name": "pair", "repeat": {"grid": {"columns": 2, "spacing": [2, 0]}}, "position": [0, 50], "shapes": [{"circle": {"radius": 0.1}}]}},
        {"at": 0.6, "body": "drop[1]", "velocity": [0, 7]},
        {"at": 1.9, "spawn": {"name": "own[3]", "position": [0, 90], "shapes": [{"circle": {"radius": 0.1}}]}}, {"at": 1.95, "despawn": "own[3]"},
        {"at": 1, "despawn": "disc"}, {"at": 1, "despawn": "drop[0]"}, {"at": 1.2, "body": "disc", "impulse": [1, 0]}])");
    SceneRun run(scene);
    const auto names = [&run] {
        std::string all;
        for (const SceneInstance& body : run.built().bodies)
            if (run.world().is_valid(body.id)) all += body.name + " ";
        return all;
    };
    run.step();
    CHECK(names() == "disc drop[0] ");
    for (int i = 0; i < 40; ++i) run.step();
    CHECK(names() == "disc drop[0] drop[1] drop[2] pair[0] pair[1] ");
    const SceneInstance& second = run.built().bodies.at(2);
    CHECK(second.name == "drop[1]");
    CHECK(run.world().state(second.id).velocity == Vec2{0.0f, 7.0f});
    CHECK(source_of(scene, second).name == "drop");
    CHECK(run.world().state(run.built().bodies.at(5).id).pose.position == DVec2{2.0, 50.0});
    for (int i = 0; i < 60; ++i) run.step();
    CHECK(names() == "drop[1] drop[2] pair[0] pair[1] ");
}

TEST_CASE("a name may be used again after its body was despawned, and events act on the new body") {
    const Scene scene = make_disc_scene(
        R"("timeline": [{"at": 0, "spawn": {"name": "late", "position": [9, 9], "gravity_scale": 0, "shapes": [{"circle": {"radius": 1}}]}},
        {"at": 0.05, "body": "late", "velocity": [1, 0]}, {"at": 0.1, "despawn": "late"},
        {"at": 0.2, "spawn": {"name": "late", "position": [9, 9], "gravity_scale": 0, "shapes": [{"circle": {"radius": 1}}]}},
        {"at": 0.3, "body": "late", "velocity": [2, 0]}, {"at": 0.4, "despawn": "late"}])");
    SceneRun run(scene);
    const auto speed_of_late = [&] {
        const SceneInstance& body = run.built().bodies.back();
        return run.world().is_valid(body.id) ? run.world().state(body.id).velocity.x : -1.0f;
    };
    // Steps of 1/60 s: shown are 0.083 s, 0.15 s, 0.25 s, 0.35 s and 0.45 s.
    std::vector<float> speeds;
    for (int step = 1; step <= 27; ++step) {
        run.step();
        if (step == 5 || step == 9 || step == 15 || step == 21 || step == 27) speeds.push_back(speed_of_late());
    }
    CHECK(speeds == std::vector<float>{1.0f, -1.0f, 0.0f, 2.0f, -1.0f});
}

TEST_CASE("no run has more than a million bodies") {
    const Scene scene = make_disc_scene(
        R"("timeline": [{"at": 0, "spawn": {"name": "crowd", "repeat": {"grid": {"columns": 1000, "rows": 1000}}}}])");
    SceneRun run(scene);
    try {
        run.step();
        FAIL("1000001 bodies were made");
    } catch (const SceneError& error) {
        CHECK(error.diagnostics.front().pointer == "/timeline/0/spawn");
        CHECK(error.diagnostics.front().message ==
              "brings the number of bodies to 1000001; at most 1000000 are allowed");
    }
}

TEST_CASE("motors change their speed, a mouse joint its target, and a joint is released") {
    const std::string bodies =
        R"({"format": 1, "world": {"gravity": [0, 0]}, "bodies": [{"name": "base", "type": "static"},
        {"name": "arm", "shapes": [{"box": {"size": [2, 0.5]}}]}], "joints": [)";
    SceneRun motor(
        parse_scene(bodies + R"({"type": "revolute", "name": "m", "bodies": ["base", "arm"], "anchor": [0, 0],
        "motor": {"speed": 0, "max_torque": 1000}}], "timeline": [{"at": 0.5, "joint": "m", "motor_speed": 90}, {"at": 1, "release": "m"}]})",
                    ""));
    for (int i = 0; i < 30; ++i) motor.step();
    CHECK(motor.world().state(motor.built().bodies.at(1).id).angular_velocity == 0.0f);
    for (int i = 0; i < 20; ++i) motor.step();
    CHECK(near(motor.world().state(motor.built().bodies.at(1).id).angular_velocity, kPi / 2, kFloat));
    for (int i = 0; i < 20; ++i) motor.step();
    CHECK(motor.world().joints().empty());
    SceneRun mouse(parse_scene(
        bodies + R"({"type": "mouse", "name": "m", "bodies": ["base", "arm"], "anchor": [0, 0], "max_force": 1000}],
        "timeline": [{"at": 0, "joint": "m", "target": [3, 1]}]})",
        ""));
    for (int i = 0; i < 180; ++i) mouse.step();
    const DVec2 position = mouse.world().state(mouse.built().bodies.at(1).id).pose.position;
    CHECK(length(position - DVec2{3.0, 1.0}) < 1e-2);
}

TEST_CASE("events of one condition happen in the order of the file, between those of other conditions") {
    // Each sets the velocity, so that the last one of a step remains.
    Scene scene = parse_scene(R"({"format": 1, "world": {"gravity": [0, 0], "steps_per_second": 10}, "bodies": [
        {"name": "disc", "shapes": [{"circle": {"radius": 0.5}}]}], "timeline": [
        {"when": "disc.x >= 1", "body": "disc", "velocity": [2, 0]},
        {"at": 0, "body": "disc", "velocity": [10, 0]},
        {"when": "disc.x >= 1", "body": "disc", "velocity": [3, 0]},
        {"when": "disc.x >= 1", "body": "disc", "velocity": [4, 0], "delay": 0.2},
        {"at": 0.1, "body": "disc", "velocity": [1, 0]}]})",
                              "");
    CHECK(speed_after(scene, 1) == 10.0f);
    CHECK(speed_after(scene, 2) == 1.0f);
    CHECK(speed_after(scene, 3) == 1.0f);
    CHECK(speed_after(scene, 4) == 4.0f);
    scene.timeline[4].at = 0.3;
    CHECK(speed_after(scene, 2) == 3.0f);
    CHECK(speed_after(scene, 4) == 1.0f);
    // With a frame of its own, the third event has a condition of its own.
    scene.timeline[2].frame = SceneFrame{.position = {1.5, 0.0}};
    CHECK(speed_after(scene, 2) == 2.0f);
    CHECK(speed_after(scene, 20) == 3.0f);
}

TEST_CASE("an invalid timeline is refused at its entry") {
    const auto pointer_of = [](const std::string& event, const std::string& more = "") {
        try {
            make_disc_scene(more + R"("timeline": [)" + event + "]");
        } catch (const SceneError& error) {
            return error.diagnostics.front().pointer;
        }
        return std::string("accepted");
    };
    CHECK(pointer_of(R"({"at": 1, "body": "disk", "impulse": [1, 0]})") == "/timeline/0/body");
    CHECK(pointer_of(R"({"at": 1, "impulse": [1, 0]})") == "/timeline/0");
    CHECK(pointer_of(R"({"at": 1, "despawn": "missing"})") == "/timeline/0/despawn");
    CHECK(pointer_of(R"({"every": 1, "despawn": "disc"})") == "/timeline/0/every");
    CHECK(pointer_of(R"({"every": 1, "body": "disc", "force": [1, 0]})") == "/timeline/0/every");
    CHECK(pointer_of(R"({"at": 1, "until": 1, "body": "disc", "force": [1, 0]})") == "/timeline/0/until");
    CHECK(pointer_of(R"({"at": 1, "until": 2, "body": "disc", "impulse": [1, 0]})") == "/timeline/0/until");
    CHECK(pointer_of(R"({"at": 1, "joint": "hinge", "motor_speed": 3})") == "/timeline/0/joint");
    CHECK(pointer_of(R"({"at": 1, "release": "hinge"})") == "/timeline/0/release");
    CHECK(pointer_of(R"({"at": 1, "body": "disc", "gravity": [0, 0]})") == "/timeline/0/body");
    CHECK(pointer_of(R"({"at": 1, "spawn": {"name": "disc"}})") == "/timeline/0/spawn/name");
    CHECK(pointer_of(R"({"at": 1, "spawn": {"name": "drop"}}, {"at": 2, "despawn": "drop"})") == "accepted");
    CHECK(pointer_of(R"({"at": 1, "spawn": {"name": "drop"}}, {"at": 2, "despawn": "drop[0]"})") ==
          "/timeline/1/despawn");
    CHECK(pointer_of(R"({"at": 1, "impulse": [1, 0], "torque": 1, "body": "disc"})") == "/timeline/0/torque");
}
