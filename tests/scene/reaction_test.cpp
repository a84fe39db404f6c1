// Events that wait for a condition, stops, and their saved state.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "scene/disc_scene.hpp"
#include "support/near.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_run.hpp"

using namespace tumble;
using test::make_disc_scene, test::near, test::relative;

namespace {

double x_of_disc(const SceneRun& run) { return run.world().state(run.built().bodies[0].id).pose.position.x; }
double vx_of_disc(const SceneRun& run) { return double{run.world().state(run.built().bodies[0].id).velocity.x}; }

// A disc that moves at 1 m/s, and an event.
SceneRun moving_disc(const std::string& event) {
    return SceneRun(make_disc_scene(R"("timeline": [{"at": 0, "body": "disc", "velocity": [1, 0]}, {)" + event + "}]"));
}

// The step before which the velocity changes to `after`, or -1.
int step_of_change(SceneRun run, double after) {
    for (int step = 0; step < 120; ++step) {
        run.step();
        if (vx_of_disc(run) == after) return step;
    }
    return -1;
}

}  // namespace

TEST_CASE("an event with a condition happens once, before the step after the state in which it first holds") {
    // The disc is at k / 60 m after step k: the state after 31 steps is the first beyond 0.51 m.
    CHECK(step_of_change(moving_disc(R"("when": "disc.x > 0.51", "body": "disc", "velocity": [3, 0])"), 3.0) == 31);
    CHECK(step_of_change(moving_disc(R"("when": "disc.x > 0.51", "delay": 0.1, "body": "disc", "velocity": [3, 0])"),
                         3.0) == 37);
    CHECK(step_of_change(moving_disc(R"("when": "disc.x > 51", "body": "disc", "velocity": [3, 0])"), 3.0) == -1);
    CHECK(step_of_change(moving_disc(R"("when": "disc.x > 0.01", "frame": {"position": [0.5, 0]}, "body": "disc",
                                        "velocity": [3, 0])"),
                         3.0) == 31);
    SceneRun run = moving_disc(R"("when": "disc.x > 0.51", "body": "disc", "velocity": [-1, 0])");
    for (int i = 0; i < 240; ++i) run.step();
    CHECK(vx_of_disc(run) == -1.0);  // and it stays so when the disc is left of 0.51 m
    CHECK(x_of_disc(run) < -1.0);
}

TEST_CASE("a force with a condition lasts from then on") {
    SceneRun run = moving_disc(R"("when": "disc.x >= 0.49", "until": 1.5, "body": "disc", "force": [0, 1])");
    double vy = 0.0;
    for (int i = 0; i < 120; ++i) run.step();
    vy = double{run.world().state(run.built().bodies[0].id).velocity.y};
    // 1 N on pi / 4 kg for the 60 steps from 0.5 s to 1.5 s.
    CHECK(near(vy, 4.0 / 3.14159265, relative(1e-4)));
}

TEST_CASE("contacts, joints and spawned bodies can be conditions") {
    const Scene scene = parse_scene(R"~({"format": 1, "bodies": [
        {"name": "floor", "type": "static", "shapes": [{"box": {"size": [40, 1]}}]},
        {"name": "ball", "position": [0, 3], "shapes": [{"circle": {"radius": 0.5}}]},
        {"name": "arm", "position": [9, 5], "shapes": [{"box": {"size": [2, 0.2], "center": [1, 0]}}]}],
      "joints": [{"type": "revolute", "name": "pivot", "bodies": ["floor", "arm"], "anchor": [9, 5]}],
      "timeline": [
        {"when": "touching(ball, floor)", "spawn": {"name": "bell", "position": [-5, 9], "shapes": [{"circle": {"radius": 0.5}}]}},
        {"when": "pivot.angle < -45", "release": "pivot"},
        {"when": "bell.exists and not pivot.exists", "delay": 0.25, "stop": true}]})~",
                                    "scene.json");
    SceneRun run(scene);
    std::uint64_t begin = 0, stop = 0;
    for (int i = 0; i < 300 && stop == 0; ++i) {
        run.step();
        if (begin == 0 && !run.world().events().contact_begins.empty()) begin = run.world().step_count();
        if (begin != 0 && run.world().step_count() == begin + 1) CHECK(run.built().bodies.size() == 4);
        if (run.is_stopped()) stop = run.world().step_count();
    }
    // The ball falls 2 m in 0.63 s.
    CHECK(begin >= 37);
    CHECK(begin <= 39);
    CHECK_FALSE(run.world().is_valid(run.built().joints[0].id));
    CHECK(stop >= begin + 16);
    CHECK(stop < 300);
}

TEST_CASE("a condition can push, turn gravity on, drive a motor, and ask whether a body is in a region") {
    // An impulse of 2 N s on a disc of pi / 4 kg, when it has moved 0.5 m.
    SceneRun pushed = moving_disc(R"("when": "disc.x >= 0.49", "body": "disc", "impulse": [0, 2])");
    for (int i = 0; i < 40; ++i) pushed.step();
    CHECK(near(double{pushed.world().state(pushed.built().bodies[0].id).velocity.y}, 8.0 / 3.14159265, relative(1e-6)));

    // It is in the region from x = 0.51 on: gravity acts from the step after the state of step 31.
    SceneRun falling = moving_disc(R"~("when": "inside(disc, 0.505, -1, 2, 1)", "gravity": [0, -6])~");
    for (int i = 0; i < 31; ++i) falling.step();
    CHECK(falling.world().state(falling.built().bodies[0].id).velocity.y == 0.0f);
    for (int i = 0; i < 30; ++i) falling.step();
    CHECK(near(double{falling.world().state(falling.built().bodies[0].id).velocity.y}, -3.0, relative(1e-5)));

    // A motor that turns a wheel about its centre at 90 degrees/s from the moment at which the disc is at 0.51 m.
    SceneRun driven(parse_scene(R"({"format": 1, "world": {"gravity": [0, 0]}, "bodies": [
        {"name": "disc", "velocity": [1, 0], "shapes": [{"circle": {"radius": 0.5}}]},
        {"name": "post", "type": "static", "position": [9, 9]},
        {"name": "wheel", "position": [9, 9], "shapes": [{"circle": {"radius": 0.5}}]}],
      "joints": [{"type": "revolute", "name": "axle", "bodies": ["post", "wheel"], "anchor": [9, 9],
                  "motor": {"speed": 0, "max_torque": 1000}}],
      "timeline": [{"when": "disc.x > 0.51", "joint": "axle", "motor_speed": 90}]})",
                                "scene.json"));
    const auto spin = [&] { return double{driven.world().state(driven.built().bodies[2].id).angular_velocity}; };
    for (int i = 0; i < 31; ++i) driven.step();
    CHECK(spin() == 0.0);
    for (int i = 0; i < 30; ++i) driven.step();
    CHECK(near(spin(), 1.5707963, relative(1e-3)));
}

TEST_CASE("a stop ends a run in the first state in which it is due") {
    SceneRun run = moving_disc(R"("at": 0.5, "stop": true)");
    for (int i = 0; i < 29; ++i) run.step();
    CHECK_FALSE(run.is_stopped());
    run.step();
    CHECK(run.is_stopped());
    CHECK(moving_disc(R"("when": "disc.x < 1", "stop": true)").is_stopped());
}

TEST_CASE("a run whose conditions have held continues from its bytes as if it had not been saved") {
    const Scene scene = make_disc_scene(R"("timeline": [{"at": 0, "body": "disc", "velocity": [1, 0]},
        {"when": "disc.x > 0.5 and disc.x < 0.53", "delay": 0.5, "body": "disc", "velocity": [0, 2]},
        {"when": "work > 1", "delay": 0.25, "stop": true}])");
    SceneRun whole(scene);
    std::vector<std::vector<std::byte>> saved;
    std::vector<std::uint64_t> hashes;
    std::vector<bool> stops;
    for (int i = 0; i < 100; ++i) {
        saved.push_back(whole.save(scene));
        hashes.push_back(whole.world().state_hash());
        stops.push_back(whole.is_stopped());
        whole.step();
    }
    CHECK_FALSE(stops.front());
    CHECK(stops.back());
    for (std::size_t start = 0; start < saved.size(); start += 9) {
        SceneRun run = SceneRun::load(scene, saved[start]);
        for (std::size_t i = start; i < saved.size(); ++i) {
            CAPTURE(start);
            REQUIRE(run.world().state_hash() == hashes[i]);
            REQUIRE(run.is_stopped() == stops[i]);
            run.step();
        }
    }
}

TEST_CASE("the conditions of an included file are about its own bodies, in its own coordinates") {
    LoadOptions options;
    options.read_included = [](const std::filesystem::path&) {
        return R"({"format": 1, "bodies": [{"name": "my ball", "position": [0, 2], "shapes": [{"circle": {"radius": 0.5}}]}],
            "timeline": [{"when": "'my ball'.x > 0.51", "body": "my ball", "velocity": [0, 7]}],
            "expect": [{"that": "'my ball'.x > 0.51", "when": "sometime"}, {"that": "energy > 0"}]})";
    };
    const Scene scene = parse_scene(R"({"format": 1, "world": {"gravity": [0, 0]},
        "include": [{"file": "part.json", "position": [100, 0], "angle": 90, "prefix": "p/"}],
        "timeline": [{"at": 0, "body": "p/my ball", "velocity": [0, 1]}]})",
                                    "scene.json", options);
    CHECK(scene.timeline[1].when == "'p/my ball'.x > 0.51");
    REQUIRE(scene.expect.size() == 1);
    SceneRun run(scene);
    ExpectationWatch watch(scene, run.built());
    watch.observe(run.built());
    // Up is the x of the part: it is at 0.51 m after 31 steps, and its y is to the left.
    for (int i = 0; i < 31; ++i) run.step();
    CHECK(run.world().state(run.built().bodies[0].id).velocity == Vec2{0.0f, 1.0f});
    run.step();
    watch.observe(run.built());
    CHECK(near(double{run.world().state(run.built().bodies[0].id).velocity.x}, -7.0, relative(1e-6)));
    CHECK(watch.results()[0].passed);
}

TEST_CASE("an error in a condition is located at its column in the file") {
    try {
        parse_scene("{\"format\": 1, \"bodies\": [{\"name\": \"a\"}],\n\"expect\": [{\"that\": \"a.x \\u003c b.x\"}]}",
                    "s.json");
        FAIL("no error");
    } catch (const SceneError& error) {
        REQUIRE(error.diagnostics.size() == 1);
        CHECK(error.diagnostics[0].line == 2);
        // \u003c stands for one byte; the name b is the 33rd byte of the line.
        CHECK(error.diagnostics[0].column == 33);
        CHECK(error.diagnostics[0].message == "there is no body or joint 'b'");
    }
}
