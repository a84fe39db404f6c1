// What makes many runs of one scene cheap, and must not change their results.
#include <doctest/doctest.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tumble/scene_file.hpp"
#include "tumble/scene_run.hpp"

using namespace tumble;

namespace {

constexpr const char* kText =
    R"({"format": 1, "world": {"duration": 1}, "include": [{"file": "floor.json"}], "bodies": [
  {"name": "ball", "position": [{"uniform": [-1, 1]}, 2], "shapes": [{"circle": {"radius": 0.5}}]}], "expect": [
  {"that": "ball.y < 0.6"}, {"that": "ball.y > 3"}, {"that": "ball.y < 3", "when": "always"},
  {"that": "ball.y > 1.99", "when": "sometime"}, {"that": "ball.y > 1.9", "at": 0.1}, {"that": "ball.y > 9", "from": 0.5, "when": "sometime"},
  {"that": "ball.y < 0.6", "until": 0.5, "when": "sometime"}, {"body": "ball", "touches": "floor"}, {"that": "ball.y > 0", "at": 2}]})";

std::string included_text(const std::filesystem::path& file) {
    if (file == "scene.json") return kText;
    return R"({"format": 1, "bodies": [{"name": "floor", "type": "static", "shapes": [{"segment": {"from": [-9, 0], "to": [9, 0]}}]}]})";
}

std::vector<ExpectationResult> results_of(const Scene& scene, bool tells_last_state) {
    SceneRun run(scene);
    ExpectationWatch watch(scene, run.built());
    watch.observe(run.built());
    const std::uint64_t steps = count_steps(scene);
    for (std::uint64_t step = 1; step <= steps; ++step) {
        run.step();
        tells_last_state&& step < steps ? watch.observe_before_end(run.built()) : watch.observe(run.built());
    }
    return watch.results();
}

}  // namespace

TEST_CASE("claims are decided alike when the states before the last are observed as such") {
    const Scene scene = load_scene("scene.json", {.overrides = {}, .seed = 3, .read_included = included_text});
    const std::vector<ExpectationResult> all = results_of(scene, false), marked = results_of(scene, true);
    REQUIRE(all.size() == 9);
    int failed = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        CAPTURE(all[i].claim);
        CHECK(marked[i].passed == all[i].passed);
        CHECK(marked[i].finding == all[i].finding);
        CHECK(marked[i].step == all[i].step);
        failed += all[i].passed ? 0 : 1;
    }
    CHECK(failed == 4);  // above 3 m, above 9 m, below 0.6 m until 0.5 s (it is at 0.75 m), and a time after the end
}

TEST_CASE("a source gives the scenes that load_scene gives, and the same errors") {
    const SceneSource source("scene.json", included_text);
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        const LoadOptions options{.overrides = {"/bodies/ball/position/1=" + std::to_string(seed)},
                                  .seed = seed,
                                  .read_included = included_text};
        CHECK(to_json(source.load(options)) == to_json(load_scene("scene.json", options)));
    }
    const LoadOptions wrong{.overrides = {"/bodies/bal/angle=1"}, .seed = {}, .read_included = included_text};
    const auto error_of = [](const auto& load) -> std::string {
        try {
            load();
        } catch (const SceneError& error) {
            return error.what();
        }
        return "";
    };
    const std::string expected = error_of([&] { load_scene("scene.json", wrong); });
    CHECK(expected.find("did you mean 'ball'?") != std::string::npos);
    CHECK(error_of([&] { source.load(wrong); }) == expected);
    // A text that is no JSON is reported by load().
    const auto cut = [](const std::filesystem::path&) { return std::string(R"({"format": 1, "bodies": [)"); };
    const SceneSource broken("scene.json", cut);
    CHECK(error_of([&] { broken.load({}); }) == error_of([&] { parse_scene(cut(""), "scene.json"); }));
}
