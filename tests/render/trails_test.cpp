// The paths of bodies and the skins of soft bodies.
#include "render/frame/trails.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "render/frame/draw_list.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_run.hpp"

using namespace tumble;
using namespace tumble::render;

namespace {

const View kView{{0.0, 0.0}, 10.0, 640, 360};

Scene ball_scene(const std::string& trail) {
    return parse_scene(R"({"format": 1, "world": {"gravity": [0, 0]}, "bodies": [
        {"name": "ball", "velocity": [3, 0], )" +
                           trail + R"("shapes": [{"circle": {"radius": 0.5}}]}]})",
                       "scene.json");
}

Scene ring_scene(const std::string& skin) {
    return parse_scene(R"({"format": 1, "world": {"gravity": [0, 0]}, "bodies": [
        {"name": "core", "shapes": [{"circle": {"radius": 0.2}}]},
        {"name": "bead", "repeat": {"ring": {"count": 6, "radius": 2}}, )" +
                           skin + R"("shapes": [{"circle": {"radius": 0.3}}]}],
        "joints": [{"type": "distance", "bodies": ["core", "bead[0]"], "anchors": [[0, 0], [0, 0]], "spring": {"hertz": 2}}]})",
                       "scene.json");
}

}  // namespace

TEST_CASE("a trail has the positions of its body after each step, and half of them when it is full") {
    const Scene scene = ball_scene(R"("trail": true, )");
    SceneRun run(scene);
    std::vector<Trail> trails;
    record_trails(trails, scene, run.built());
    for (int i = 0; i < 60; ++i) {
        run.step();
        record_trails(trails, scene, run.built());
    }
    REQUIRE(trails.size() == 1);
    REQUIRE(trails[0].points.size() == 61);
    CHECK(trails[0].points.front() == DVec2{0.0, 0.0});
    CHECK(trails[0].points.back() == run.world().state(trails[0].body).pose.position);
    for (std::size_t i = trails[0].points.size(); i < kMostTrailPoints; ++i) {
        run.step();
        record_trails(trails, scene, run.built());
    }
    CHECK(trails[0].points.size() == kMostTrailPoints / 2);
    CHECK(trails[0].stride == 2);
    const Scene without = ball_scene("");
    SceneRun other(without);
    std::vector<Trail> none;
    record_trails(none, without, other.built());
    CHECK(none.empty());
}

TEST_CASE("a trail is drawn below its body, also after the body is destroyed") {
    const Scene scene = ball_scene(R"("trail": true, )");
    SceneRun run(scene);
    std::vector<Trail> trails;
    record_trails(trails, scene, run.built());
    for (int i = 0; i < 60; ++i) {
        run.step();
        record_trails(trails, scene, run.built());
    }
    DrawList list;
    build_draw_list(list, scene, run.built(), kView, trails);
    double drawn = 0.0;
    for (const BoxInstance& line : list.sensors.boxes) drawn += 2.0 * std::max(line.half_x, line.half_y);
    CHECK(drawn > 29.0);  // 3 m of 10 pixels
    CHECK(drawn < 31.0);
    run.world().destroy_body(trails[0].body);
    const std::size_t lines = list.sensors.boxes.size();
    build_draw_list(list, scene, run.built(), kView, trails);
    CHECK(list.sensors.boxes.size() == lines);
}

TEST_CASE("a skin fills the loop through the copies and hides the springs below it") {
    const Scene bare = ring_scene("");
    const SceneWorld beads = build_world(bare);
    DrawList list;
    build_draw_list(list, bare, beads, kView);
    CHECK(list.islands.mesh.empty());
    CHECK(list.details.boxes.size() > 10);  // the coil, and the marks of the beads
    const std::size_t with_coil = list.details.boxes.size();

    const Scene soft = ring_scene(R"("skin": true, )");
    SceneWorld built = build_world(soft);
    build_draw_list(list, soft, built, kView);
    CHECK(list.islands.mesh.size() == 6 * 3);
    CHECK(list.islands.boxes.size() == 6);
    CHECK(list.details.boxes.size() + 8 < with_coil);
    built.world.destroy_body(built.bodies.at(3).id);
    build_draw_list(list, soft, built, kView);
    CHECK(list.islands.mesh.empty());
}
