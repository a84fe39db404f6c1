#include "tools/scene/scene_check.hpp"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <exception>
#include <thread>

#include "tools/cli/error_report.hpp"
#include "tools/cli/interrupt.hpp"
#include "tools/measure/stopwatch.hpp"
#include "tools/scene/scene_options.hpp"

namespace tumble::tools {

namespace {

void simulate_and_check(const Scene& scene, SceneCheck& check) {
    check.name = file_name_of(scene.name);
    SceneRun run(scene);
    ExpectationWatch watch(scene, run.built());
    watch.observe(run.built());
    const std::uint64_t step_count = count_steps(scene);
    while (check.steps < step_count && !is_interrupted()) {
        run.step();
        watch.observe(run.built());
        ++check.steps;
    }
    check.state_hash = run.world().state_hash();
    check.expectations = watch.results();
    if (check.steps < step_count) {
        check.code = ExitCode::interrupted;
        check.error = "interrupted at step " + std::to_string(check.steps) + " of " + std::to_string(step_count);
        return;
    }
    for (const ExpectationResult& result : check.expectations)
        if (!result.passed) check.code = ExitCode::failed;
}

}  // namespace

SceneCheck check_scene_file(const std::string& file, const LoadOptions& changes) {
    SceneCheck check;
    check.file = file;
    check.name = file_name_of(std::filesystem::path(file).stem().string());
    const Stopwatch watch;
    try {
        simulate_and_check(load_named_scene(file, changes), check);
    } catch (...) {
        const Problem problem = explain(std::current_exception());
        check.code = problem.code;
        check.error = problem.message;
    }
    check.seconds = watch.seconds();
    return check;
}

std::vector<SceneCheck> check_scene_files(const std::vector<std::string>& files, const LoadOptions& changes,
                                          int threads) {
    std::vector<SceneCheck> checks(files.size());
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        for (std::size_t i = next++; i < files.size(); i = next++) checks[i] = check_scene_file(files[i], changes);
    };
    {
        std::vector<std::jthread> others;
        for (int i = 1; i < threads; ++i) others.emplace_back(work);
        work();
    }
    return checks;
}

std::string moment_text(const ExpectationResult& result) {
    char text[64];
    std::snprintf(text, sizeof text, "at %.4g s (step %llu)", result.time,
                  static_cast<unsigned long long>(result.step));
    return text;
}

std::string pointer_of_claim(std::size_t index) { return "/expect/" + std::to_string(index); }

}  // namespace tumble::tools
