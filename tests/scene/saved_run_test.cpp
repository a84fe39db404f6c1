// A run that is saved and continued.
#include <doctest/doctest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "scene/disc_scene.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_run.hpp"

using namespace tumble;

namespace {

// Bodies that appear, disappear and are pushed, also a while after a condition held, and a joint that is released.
Scene eventful_scene() {
    return parse_scene(R"({"format": 1, "bodies": [
        {"name": "floor", "type": "static", "position": [0, -1], "shapes": [{"box": {"size": [40, 1]}}]},
        {"name": "crate", "position": [0, 1], "repeat": {"grid": {"rows": 3}}, "shapes": [{"box": {"size": [1, 1]}}]}],
      "joints": [{"type": "revolute", "name": "hinge", "bodies": ["floor", "crate[2]"], "anchor": [0, 3]}],
      "timeline": [
        {"every": 0.2, "spawn": {"name": "drop", "position": [0, 8], "shapes": [{"circle": {"radius": 0.3}}]}},
        {"at": 0.7, "despawn": "crate[0]"},
        {"at": 0.9, "release": "hinge"},
        {"when": "drop[2].exists", "delay": 0.3, "body": "crate[1]", "impulse": [0, 2]},
        {"every": 0.3, "body": "drop[1]", "impulse": [1, 2]},
        {"at": 0.5, "until": 1.5, "body": "crate[1]", "force": [30, 0]}]})",
                       "scene.json");
}

// Everything that a run shows: its state and the names of its bodies.
std::string trace_of(const SceneRun& run) {
    std::string text = std::to_string(run.world().state_hash()) + " " + std::to_string(run.time());
    for (const SceneInstance& body : run.built().bodies)
        text += " " + body.name + (run.world().is_valid(body.id) ? "+" : "-") + std::to_string(body.source);
    return text;
}

void check_damaged(const Scene& scene, const std::vector<std::byte>& bytes) {
    CHECK_THROWS_AS(SceneRun::load(scene, bytes), SnapshotError);
}

}  // namespace

TEST_CASE("a run that is saved at any step continues as if it had not been") {
    const Scene scene = eventful_scene();
    constexpr int kSteps = 120;
    std::vector<std::string> traces;
    std::vector<std::vector<std::byte>> saved;
    SceneRun whole(scene);
    for (int i = 0; i < kSteps; ++i) {
        traces.push_back(trace_of(whole));
        saved.push_back(whole.save(scene));
        whole.step();
    }
    for (int start = 0; start < kSteps; start += 7) {
        SceneRun continued = SceneRun::load(scene, saved[static_cast<std::size_t>(start)]);
        for (int i = start; i < kSteps; ++i) {
            CAPTURE(start);
            REQUIRE(trace_of(continued) == traces[static_cast<std::size_t>(i)]);
            continued.step();
        }
    }
}

TEST_CASE("a saved run continues in a scene with another duration and other claims") {
    Scene scene = eventful_scene();
    SceneRun run(scene);
    for (int i = 0; i < 30; ++i) run.step();
    const std::vector<std::byte> saved = run.save(scene);
    scene.world.duration += 3.0;
    scene.expect.emplace_back().max_penetration = 0.1;
    SceneRun continued = SceneRun::load(scene, saved);
    run.step();
    continued.step();
    CHECK(trace_of(continued) == trace_of(run));
}

TEST_CASE("a saved run of another scene, or one that is damaged, is refused") {
    const Scene scene = eventful_scene();
    SceneRun run(scene);
    for (int i = 0; i < 30; ++i) run.step();
    const std::vector<std::byte> saved = run.save(scene);
    Scene heavier = scene;
    heavier.world.gravity.y = -20.0;
    check_damaged(heavier, saved);
    check_damaged(scene, {});
    for (std::size_t size = 0; size < saved.size(); size += saved.size() / 50)
        check_damaged(scene, {saved.begin(), saved.begin() + static_cast<std::ptrdiff_t>(size)});
    for (std::size_t at = 0; at < saved.size(); at += saved.size() / 50) {
        std::vector<std::byte> changed = saved;
        changed[at] ^= std::byte{1};
        check_damaged(scene, changed);
    }
}

namespace {

Scene watched_scene() {
    Scene scene = eventful_scene();
    const Scene claims = parse_scene(R"({"format": 1, "bodies": [
        {"name": "floor", "type": "static"}, {"name": "crate", "repeat": {"grid": {"rows": 3}}}],
      "timeline": [{"every": 0.2, "spawn": {"name": "drop"}}],
      "expect": [{"max_energy_gain": 1}, {"max_penetration": 0.01}, {"body": "crate", "touches": "floor"},
        {"body": "drop", "never_touches": "floor"}, {"event": "contact_begin", "event_count": [3, 5]},
        {"body": "crate[1]", "speed": [0, 1], "when": "always"}, {"body": "crate[1]", "height": [0, 0.4], "at": 1}]})",
                                     "claims.json");
    scene.expect = claims.expect;
    return scene;
}

// Pushes a body, brakes another by a new joint and removes a third, between the steps of a run.
void act(SceneRun& run, int step) {
    World& world = run.world();
    if (step == 20) world.create_body({.pose = {{0.5, 5.0}, {}}}, std::vector<ShapeDef>{{.shape = make_circle(0.2f)}});
    if (step == 40) world.apply_impulse(run.built().bodies.at(2).id, {0.0f, 3.0f});
    if (step == 50) world.destroy_body(run.built().bodies.at(4).id);
}

std::string text_of(const std::vector<ExpectationResult>& results) {
    std::string text;
    for (const ExpectationResult& result : results)
        text += std::to_string(result.passed) + result.claim + result.finding + std::to_string(result.step) + "\n";
    return text;
}

}  // namespace

TEST_CASE("a run that a program acts on continues its timeline, and is saved with what was done and seen") {
    const Scene scene = watched_scene();
    constexpr int kSteps = 120;
    SceneRun whole(scene);
    ExpectationWatch watch(scene, whole.built());
    watch.observe(whole.built());
    std::vector<std::vector<std::byte>> runs, watches;
    for (int i = 0; i < kSteps; ++i) {
        runs.push_back(whole.save(scene));
        watches.push_back(watch.save());
        act(whole, i);
        whole.step();
        watch.observe(whole.built());
    }
    CHECK(whole.built().bodies.size() == 4 + 10);  // the timeline still spawned its ten drops
    for (int start = 0; start < kSteps; start += 7) {
        CAPTURE(start);
        SceneRun run = SceneRun::load(scene, runs[static_cast<std::size_t>(start)]);
        ExpectationWatch continued =
            ExpectationWatch::load(scene, build_world(scene), watches[static_cast<std::size_t>(start)]);
        for (int i = start; i < kSteps; ++i) {
            act(run, i);
            run.step();
            continued.observe(run.built());
        }
        CHECK(trace_of(run) == trace_of(whole));
        CHECK(text_of(continued.results()) == text_of(watch.results()));
    }
}

TEST_CASE("saved claims of another scene, or damaged ones, are refused") {
    const Scene scene = watched_scene();
    const SceneRun run(scene);
    const std::vector<std::byte> saved = ExpectationWatch(scene, run.built()).save();
    Scene other = scene;
    other.expect.pop_back();
    CHECK_THROWS_AS(ExpectationWatch::load(other, run.built(), saved), SnapshotError);
    other = scene;
    other.expect.front().max_energy_gain = 2.0;
    CHECK_THROWS_AS(ExpectationWatch::load(other, run.built(), saved), SnapshotError);
    CHECK_THROWS_AS(ExpectationWatch::load(scene, run.built(), run.save(scene)), SnapshotError);
    for (std::size_t at = 0; at < saved.size(); at += 37) {
        std::vector<std::byte> changed = saved;
        changed[at] ^= std::byte{1};
        CHECK_THROWS_AS(ExpectationWatch::load(scene, run.built(), changed), SnapshotError);
        changed.resize(at);
        CHECK_THROWS_AS(ExpectationWatch::load(scene, run.built(), changed), SnapshotError);
    }
}
