#include "tools/scene/scene_check.hpp"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <exception>
#include <thread>

#include "tools/cli/console.hpp"
#include "tools/cli/error_report.hpp"
#include "tools/cli/interrupt.hpp"
#include "tools/measure/stopwatch.hpp"
#include "tools/output/standard_input.hpp"
#include "tools/scene/outer_claims.hpp"
#include "tools/scene/scene_options.hpp"

namespace tumble::tools {

namespace {

void decide_outer_claims(const Scene& scene, const CheckOptions& options, SceneCheck& check) {
    const std::filesystem::path file = is_standard_input(check.file) ? "" : check.file;
    const EndedRun run{scene, file.parent_path(), check.steps, options.changes.allow_outside, options.renderer};
    for (ExpectationResult& result : check.expectations) {
        if (result.is_decided) continue;
        result.passed = false;
        result.finding = "it was not decided, because the scene could not be checked";
    }
    for (std::size_t i = 0; i < scene.expect.size(); ++i) {
        ExpectationResult& result = check.expectations[i];
        if (!result.is_decided && decide_outer_claim(run, scene.expect[i], options.update, result))
            check.pictures.push_back({pointer_of_claim(i) + "/picture", run.folder / scene.expect[i].picture});
    }
}

void simulate_and_check(const Scene& scene, const CheckOptions& options, SceneCheck& check) {
    check.name = file_name_of(scene.name);
    if (options.require_claims && scene.expect.empty()) {
        check.code = ExitCode::failed;
        check.failure = "has no claims, and --require-claims is given: list what must be true in \"expect\"";
        return;
    }
    for (const SceneExpectation& claim : scene.expect) check.claimed_hashes.push_back(claim.state_hash);
    SceneRun run(scene);
    ExpectationWatch watch(scene, run.built());
    watch.observe(run.built());
    const std::uint64_t step_count = count_steps(scene);
    while (check.steps < step_count && !run.is_stopped() && !is_interrupted()) {
        run.step();
        watch.observe(run.built());
        ++check.steps;
    }
    check.state_hash = run.world().state_hash();
    if (check.steps < step_count && !run.is_stopped()) {
        check.code = interruption_code();
        check.error = "interrupted at step " + std::to_string(check.steps) + " of " + std::to_string(step_count);
        return;
    }
    check.expectations = watch.results();
    decide_outer_claims(scene, options, check);
    check.was_simulated = true;
    for (const ExpectationResult& result : check.expectations)
        if (!result.passed) check.code = ExitCode::failed;
}

// The result of a file before it is read.
SceneCheck unread(const std::string& file) {
    SceneCheck check;
    check.file = file;
    check.name = is_standard_input(file) ? "stdin" : file_name_of(std::filesystem::path(file).stem().string());
    return check;
}

}  // namespace

SceneCheck check_scene_file(const std::string& file, const CheckOptions& options) {
    SceneCheck check = unread(file);
    const Stopwatch watch;
    try {
        simulate_and_check(load_named_scene(file, options.changes), options, check);
    } catch (...) {
        const Problem problem = explain(std::current_exception());
        check.code = problem.code;
        check.error = problem.message;
    }
    check.seconds = watch.seconds();
    return check;
}

std::vector<SceneCheck> check_scene_files(const std::vector<std::string>& files, const CheckOptions& options) {
    std::vector<SceneCheck> checks(files.size());
    std::atomic<std::size_t> next{0}, done{0};
    std::atomic<bool> has_failed{false};
    Progress progress("scenes checked", files.size());
    const auto work = [&] {
        for (std::size_t i = next++; i < files.size(); i = next++) {
            if (options.stop_at_failure && has_failed) {
                checks[i] = unread(files[i]);
                checks[i].was_skipped = true;
                continue;
            }
            checks[i] = check_scene_file(files[i], options);
            if (checks[i].code != ExitCode::ok) has_failed = true;
            progress.show(++done);
        }
    };
    {
        std::vector<std::jthread> others;
        for (int i = 1; i < options.threads; ++i) others.emplace_back(work);
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
