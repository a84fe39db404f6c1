#include "tools/scene/outer_claims.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "tools/cli/interrupt.hpp"
#include "tools/cli/output_path.hpp"
#include "tools/output/number_text.hpp"
#include "tools/run/run_options.hpp"
#include "tools/scene/scene_options.hpp"
#include "tumble/file.hpp"
#include "tumble/render.hpp"

namespace tumble::tools {

namespace {

Image draw_at(const EndedRun& ended, std::uint64_t step, int width, int height) {
    const Scene& scene = ended.scene;
    SceneRun run(scene);
    const double aspect = static_cast<double>(width) / height;
    Camera camera = make_camera(scene, run.built(), aspect);
    while (run.world().step_count() < step && !is_interrupted()) {
        run.step();
        camera = move_camera(camera, scene, run.built());
    }
    camera = apply_camera_keys(camera, scene, run.built(), aspect);
    Renderer renderer(width, height, ended.renderer);
    Image image;
    renderer.draw(scene, run.built(), camera, run.time(), image, {}, {});
    return image;
}

void compare(const Image& golden, const Image& drawn, double tolerance, ExpectationResult& result) {
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
                         ? "the largest difference is " + counted(largest, "level")
                         : counted(pixels, "pixel") + (pixels == 1 ? " differs, by up to " : " differ, by up to ") +
                               counted(largest, "level");
}

// Returns whether it was written: not if a signal has stopped the scene before its step.
bool write_picture(const EndedRun& run, const std::filesystem::path& file, ExpectationResult& result) {
    const FrameSize size;
    const Image drawn = draw_at(run, result.step, size.width, size.height);
    if (is_interrupted()) return false;
    create_folder_of(file);
    write_png(drawn, file);
    result.passed = true;
    result.finding = "the picture was missing and has been written";
    return true;
}

bool decide_picture(const EndedRun& run, const SceneExpectation& claim, bool write_missing, ExpectationResult& result) {
    const double rate = run.scene.world.steps_per_second;
    result.step = claim.at ? nearest_step(*claim.at, rate) : run.last_step;
    result.time = static_cast<double>(result.step) / rate;
    if (result.step > run.last_step) {
        result.finding = "the run ends before that";
        return false;
    }
    const std::filesystem::path file = run.folder / claim.picture;
    std::error_code unreadable;
    if (!std::filesystem::exists(file, unreadable)) {
        if (write_missing) return write_picture(run, file, result);
        throw FileError(file, "the picture of a claim is missing; `tumble check --update` writes it");
    }
    const Image golden = read_png(file);
    compare(golden, draw_at(run, result.step, golden.width, golden.height), claim.tolerance.value_or(0.0), result);
    if (write_missing && !result.passed)
        result.finding += "; to accept the new frame, delete the file and update again";
    return false;
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

void decide_time_ratio(const EndedRun& run, const SceneExpectation& claim, ExpectationResult& result) {
    LoadOptions options;
    options.allow_outside = run.allow_outside;
    const Scene reference = load_named_scene((run.folder / claim.reference).string(), options);
    std::array<double, 3> ratios{};
    for (double& ratio : ratios) ratio = time_ratio(run.scene, reference);
    std::ranges::sort(ratios);
    result.step = run.last_step;
    result.time = static_cast<double>(run.last_step) / run.scene.world.steps_per_second;
    result.passed = ratios[1] <= claim.max_time_ratio.value();
    char text[64];
    std::snprintf(text, sizeof text, "it takes %.3g times as long", ratios[1]);
    result.finding = text;
}

}  // namespace

bool decide_outer_claim(const EndedRun& run, const SceneExpectation& claim, bool write_missing,
                        ExpectationResult& result) {
    result.is_decided = true;
    if (!claim.max_time_ratio) return decide_picture(run, claim, write_missing, result);
    decide_time_ratio(run, claim, result);
    return false;
}

}  // namespace tumble::tools
