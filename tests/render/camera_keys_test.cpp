// The key frames of a camera, against closed forms.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "support/near.hpp"
#include "tumble/render.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_run.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

constexpr double kAspect = 2.0;

// Two pucks without gravity: `a` of radius 0.5 stays at (0, 0), `b` of radius 1 flies from (10, 0) to the right at 2
// m/s.
Scene pucks(const std::string& keys) {
    return parse_scene(R"({"format": 1, "world": {"gravity": [0, 0], "duration": 4},
        "camera": {"center": [3, 1], "height": 8, "keys": )" +
                           keys + R"(}, "bodies": [
        {"name": "a", "shapes": [{"circle": {"radius": 0.5}}]},
        {"name": "b", "position": [10, 0], "velocity": [2, 0], "shapes": [{"circle": {"radius": 1}}]}]})",
                       "pucks.json");
}

Camera shown_at(const std::string& keys, double time) {
    const Scene scene = pucks(keys);
    SceneRun run(scene);
    const Camera camera = make_camera(scene, run.built(), kAspect);
    while (run.time() + 1e-9 < time) run.step();
    return apply_camera_keys(camera, scene, run.built(), kAspect);
}

}  // namespace

TEST_CASE("without key frames the camera stays as it is") {
    const Camera camera = shown_at("[]", 1.0);
    CHECK(camera.center == DVec2{3.0, 1.0});
    CHECK(camera.height == 8.0);
}

TEST_CASE("between two key frames the centre and the height change by 3 u^2 - 2 u^3 of their difference") {
    const std::string keys =
        R"([{"time": 1, "center": [0, 0], "height": 4}, {"time": 3, "center": [8, -2], "height": 12}])";
    for (const double time : {0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 4.0}) {
        CAPTURE(time);
        const double u = std::min(std::max((time - 1.0) / 2.0, 0.0), 1.0), share = 3.0 * u * u - 2.0 * u * u * u;
        const Camera camera = shown_at(keys, time);
        CHECK(near(camera.center.x, 8.0 * share, absolute(1e-12)));
        CHECK(near(camera.center.y, -2.0 * share, absolute(1e-12)));
        CHECK(near(camera.height, 4.0 + 8.0 * share, absolute(1e-12)));
    }
}

TEST_CASE("a key frame keeps what it leaves out: of the one before, or of the camera") {
    const std::string zoom = R"([{"time": 0}, {"time": 1, "height": 2}, {"time": 2, "center": [5, 5]}])";
    CHECK(shown_at(zoom, 0.0).center == DVec2{3.0, 1.0});
    CHECK(shown_at(zoom, 0.0).height == 8.0);
    CHECK(shown_at(zoom, 1.0).center == DVec2{3.0, 1.0});
    CHECK(shown_at(zoom, 1.0).height == 2.0);
    CHECK(shown_at(zoom, 2.0).center == DVec2{5.0, 5.0});
    CHECK(shown_at(zoom, 2.0).height == 2.0);
}

TEST_CASE("a key frame that follows bodies has the middle of their box in the middle, while they move") {
    const std::string both = R"([{"time": 0, "follow": ["a", "b"], "height": 30}])";
    for (const double time : {0.0, 1.0, 2.0}) {
        CAPTURE(time);
        // The box goes from the left of a, -0.5, to the right of b, 11 + 2 t, and from -1 to 1.
        const Camera camera = shown_at(both, time);
        CHECK(near(camera.center.x, 0.5 * (-0.5 + 11.0 + 2.0 * time), absolute(1e-5)));
        CHECK(near(camera.center.y, 0.0, absolute(1e-5)));
        CHECK(camera.height == 30.0);
    }
}

TEST_CASE("without a height, the bodies that a key frame follows are in view, with a margin") {
    const std::string both = R"([{"time": 0, "follow": ["a", "b"]}])", one = R"([{"time": 0, "follow": ["a"]}])";
    // The box of both is 11.5 + 2 t wide, in a frame that is twice as wide as high; the margin is 14 %. A frame is at
    // least five times as high as the larger side of a body: 10 m for b, 5 m for a.
    CHECK(near(shown_at(both, 4.0).height, 1.14 * 19.5 / 2.0, absolute(1e-4)));
    CHECK(near(shown_at(both, 0.0).height, 10.0, absolute(1e-5)));
    CHECK(near(shown_at(one, 1.0).height, 5.0, absolute(1e-5)));
}

TEST_CASE("a key frame that follows a body without shapes keeps the height of the camera") {
    Scene scene = pucks(R"([{"time": 0, "follow": ["a"]}])");
    scene.bodies.at(0).shapes.clear();
    scene.bodies.at(0).position = {7.0, -2.0};
    const SceneRun run(scene);
    const Camera camera = apply_camera_keys(make_camera(scene, run.built(), kAspect), scene, run.built(), kAspect);
    CHECK(camera.center == DVec2{7.0, -2.0});
    CHECK(camera.height == 8.0);
}

TEST_CASE("a key frame whose bodies do not exist has the view of the camera") {
    const Scene scene = pucks(R"([{"time": 0, "follow": ["a"], "height": 3}])");
    SceneRun run(scene);
    const Camera camera = make_camera(scene, run.built(), kAspect);
    run.world().destroy_body(run.built().bodies.at(0).id);
    CHECK(apply_camera_keys(camera, scene, run.built(), kAspect).center == DVec2{3.0, 1.0});
    CHECK(apply_camera_keys(camera, scene, run.built(), kAspect).height == 3.0);
}
