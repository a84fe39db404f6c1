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

// Bodies that appear, disappear and are pushed, and a joint that is released.
Scene eventful_scene() {
    return parse_scene(R"({"format": 1, "bodies": [
        {"name": "floor", "type": "static", "position": [0, -1], "shapes": [{"box": {"size": [40, 1]}}]},
        {"name": "crate", "position": [0, 1], "repeat": {"grid": {"rows": 3}}, "shapes": [{"box": {"size": [1, 1]}}]}],
      "joints": [{"type": "revolute", "name": "hinge", "bodies": ["floor", "crate[2]"], "anchor": [0, 3]}],
      "timeline": [
        {"every": 0.2, "spawn": {"name": "drop", "position": [0, 8], "shapes": [{"circle": {"radius": 0.3}}]}},
        {"at": 0.7, "despawn": "crate[0]"},
        {"at": 0.9, "release": "hinge"},
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
