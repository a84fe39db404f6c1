#include "tools/shrink/failure_picture.hpp"

#include <vector>

#include "tools/claims/claim_marks.hpp"
#include "tools/cli/error_report.hpp"
#include "tools/scene/scene_shot.hpp"
#include "tools/shrink/child_process.hpp"

namespace tumble::tools {

namespace {

constexpr double kLongest = 600.0;  // s, of the simulation and the drawing

void draw(const Scene& scene, const Failure& failure, std::uint64_t step, const std::filesystem::path& file,
          RenderBackend renderer) {
    const ShotSettings settings{.overlay = {.notes = false}, .renderer = renderer};
    if (failure.claim < 0) {
        draw_scene_at(scene, step, settings, file);
        return;
    }
    const ExpectationResult result = result_of_claim(scene, failure.claim);
    draw_scene_at(scene, step, settings, file, [&](const SceneWorld& built) {
        return marks_of(scene.expect.at(static_cast<std::size_t>(failure.claim)), result, built);
    });
}

std::vector<std::uint64_t> steps_to_try(const Scene& scene, const Failure& failure) {
    if (failure.claim >= 0) return {failure.step};
    if (failure.step > 0) return {failure.step - 1};
    return {count_steps(scene), 0};
}

// The error, or nothing.
std::string draw_in_copy(const Scene& scene, const Failure& failure, std::uint64_t step,
                         const std::filesystem::path& file, RenderBackend renderer) {
    ChildProcess process(
        [&](int answer) {
            try {
                draw(scene, failure, step, file, renderer);
                write_all(answer, "drawn");
            } catch (...) {
                write_all(answer, explain(std::current_exception()).message);
            }
        },
        kLongest);
    const std::string& answer = process.wait().answer;
    if (answer == "drawn") return "";
    return answer.empty() ? "the process that draws it has ended" : answer;
}

}  // namespace

std::string draw_failure(const Scene& scene, const Failure& failure, const std::filesystem::path& file,
                         RenderBackend renderer) {
    std::string error;
    for (const std::uint64_t step : steps_to_try(scene, failure)) {
        error = draw_in_copy(scene, failure, step, file, renderer);
        if (error.empty()) break;
    }
    return error;
}

}  // namespace tumble::tools
