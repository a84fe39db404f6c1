#include "tools/scene/outer_claims.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "tools/cli/interrupt.hpp"
#include "tools/diff/png_reader.hpp"
#include "tools/scene/scene_options.hpp"
#include "tumble/render.hpp"

namespace tumble::tools {

namespace {

Image draw_at(const Scene& scene, std::uint64_t step, int width, int height) {
    SceneRun run(scene);
    const double aspect = static_cast<double>(width) / height;
    Camera camera = make_camera(scene, run.built(), aspect);
    while (run.world().step_count() < step && !is_interrupted()) {
        run.step();
        camera = move_camera(camera, scene, run.built());
    }
    Renderer renderer(width, height);
    Image image;
    renderer.draw(scene, run.built(), camera, run.time(), image, {}, {});
    return image;
}

void decide_picture(const Scene& scene, const SceneExpectation& claim, const std::filesystem::path& folder,
                    std::uint64_t last_step, ExpectationResult& result) {
    const double rate = scene.world.steps_per_second;
    result.step = claim.at ? nearest_step(*claim.at, rate) : last_step;
    result.time = static_cast<double>(result.step) / rate;
    result.passed = result.step <= last_step;
    result.finding = "the run ends before that";
    if (!result.passed) return;
    const Image golden = read_png(folder / claim.picture);
    const Image drawn = draw_at(scene, result.step, golden.width, golden.height);
    const double tolerance = claim.tolerance.value_or(0.0);
    std::size_t pixels = 0;
    int largest = 0;
    for (std::size_t pixel = 0; pixel + 3 < golden.rgba.size(); pixel += 4) {
        int apart = 0;
        for (std::size_t i = pixel; i < pixel + 4; ++i)
            apart = std::max(apart, std::abs(int{golden.rgba[i]} - int{drawn.rgba[i]}));
        pixels += apart > tolerance ? 1 : 0;
        largest = std::max(largest, apart);
    }
    result.passed = pixels == 0;
    result.finding = result.passed
                         ? "the largest difference is " + std::to_string(largest) + " levels"
                         : std::to_string(pixels) + " pixels differ, by up to " + std::to_string(largest) + " levels";
}

// Steps two scenes in turns, so that what slows down the machine slows down both. The ratio of their mean times of a
// step.
double time_ratio(const Scene& scene, const Scene& reference) {
    struct Timed {
        SceneRun run;
        std::uint64_t last = 0;
        double ms = 0.0;

        explicit Timed(const Scene& of) : run(of), last(count_steps(of)) {}
        bool step() {
            if (run.world().step_count() >= last || run.is_stopped()) return false;
            run.step();
            ms += run.world().counters().ms.step;
            return true;
        }
        double mean() const { return ms / static_cast<double>(std::max<std::uint64_t>(1, run.world().step_count())); }
    };
    Timed one(scene), other(reference);
    bool goes_on = true;
    while (goes_on && !is_interrupted()) {
        const bool first = one.step(), second = other.step();
        goes_on = first || second;
    }
    return one.mean() / other.mean();
}

void decide_time_ratio(const Scene& scene, const SceneExpectation& claim, const std::filesystem::path& folder,
                       std::uint64_t last_step, ExpectationResult& result) {
    const Scene reference = load_named_scene((folder / claim.reference).string());
    std::array<double, 3> ratios{};
    for (double& ratio : ratios) ratio = time_ratio(scene, reference);
    std::ranges::sort(ratios);
    result.step = last_step;
    result.time = static_cast<double>(last_step) / scene.world.steps_per_second;
    result.passed = ratios[1] <= claim.max_time_ratio.value();
    char text[64];
    std::snprintf(text, sizeof text, "it takes %.3g times as long", ratios[1]);
    result.finding = text;
}

}  // namespace

void decide_outer_claim(const Scene& scene, const SceneExpectation& claim, const std::filesystem::path& folder,
                        std::uint64_t last_step, ExpectationResult& result) {
    result.is_decided = true;
    if (claim.max_time_ratio) return decide_time_ratio(scene, claim, folder, last_step, result);
    decide_picture(scene, claim, folder, last_step, result);
}

}  // namespace tumble::tools
