// The README's scene: it is valid, its claims hold, and its bodies stay in its frame.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "tumble/file.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_run.hpp"

using namespace tumble;

namespace {

// The first ```jsonc block.
std::string example_of_readme() {
    const std::string readme = read_file(TUMBLE_SOURCE_DIR "/README.md", 1u << 20);
    const std::string fence = "```jsonc\n";
    const std::size_t begin = readme.find(fence) + fence.size();
    return readme.substr(begin, readme.find("```", begin) - begin);
}

}  // namespace

TEST_CASE("the README's scene has no warning, its claims hold, and no body leaves its frame or sinks") {
    std::vector<Diagnostic> warnings;
    const Scene scene = parse_scene(example_of_readme(), "README.md", &warnings);
    CHECK(warnings.empty());
    REQUIRE(!scene.expect.empty());
    REQUIRE(scene.camera.center.has_value());
    REQUIRE(scene.camera.height.has_value());
    const double half_height = 0.5 * *scene.camera.height, half_width = half_height * 16.0 / 9.0;

    SceneRun run(scene);
    ExpectationWatch watch(scene, run.built());
    watch.observe(run.built());
    const int steps = static_cast<int>(scene.world.duration * scene.world.steps_per_second);
    for (int step = 0; step < steps; ++step) {
        run.step();
        watch.observe(run.built());
        for (const SceneInstance& body : run.built().bodies) {
            if (run.world().type(body.id) != BodyType::dynamic_body) continue;
            const Pose pose = run.world().state(body.id).pose;
            const DVec2 seen = pose.position - *scene.camera.center;
            INFO(body.name, " at step ", step);
            REQUIRE(std::abs(seen.x) < half_width);
            REQUIRE(std::abs(seen.y) < half_height);
            // The ground's top is y = 0; a slop of 5 mm and a soft impact reach below it.
            for (const ShapeId shape : run.world().shapes(body.id))
                REQUIRE(bounds(run.world().shape(shape), pose).lower.y > -0.05f);
        }
    }
    for (const ExpectationResult& result : watch.results()) {
        INFO(result.claim, ": ", result.finding);
        CHECK(result.passed);
    }
}
