#include "tools/scene/scene_check.hpp"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <exception>
#include <thread>

#include "tools/cli/error_report.hpp"
#include "tools/cli/interrupt.hpp"
#include "tools/measure/stopwatch.hpp"
#include "tools/output/json_writer.hpp"
#include "tools/scene/scene_options.hpp"
#include "tumble/drawing.hpp"

namespace tumble::tools {

namespace {

void run_to_the_end(const Scene& scene, SceneCheck& check) {
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

std::string attribute(std::string_view name, std::string_view value) {
    return " " + std::string(name) + "=\"" + escape_markup(value) + "\"";
}

std::string number_text(double value) {
    std::string text;
    append_number(text, value);
    return text;
}

// A scene that could not be run is one case, in error; a claim that does not hold is a failure.
std::string junit_suite(const SceneCheck& check) {
    const bool broken = !check.error.empty();
    const auto failures = std::ranges::count(check.expectations, false, &ExpectationResult::passed);
    const std::size_t tests = check.expectations.size() + (broken ? 1 : 0);
    std::string text = "  <testsuite" + attribute("name", check.file) + attribute("tests", std::to_string(tests)) +
                       attribute("failures", std::to_string(failures)) + attribute("errors", broken ? "1" : "0") +
                       attribute("time", number_text(check.seconds)) + ">\n";
    const std::string class_name = attribute("classname", check.file);
    if (broken)
        text += "    <testcase" + class_name + attribute("name", "runs") + "><error" +
                attribute("message", check.error) + "/></testcase>\n";
    for (std::size_t i = 0; i < check.expectations.size(); ++i) {
        const ExpectationResult& result = check.expectations[i];
        // With its place: two claims may read the same, and viewers merge cases of one name.
        text += "    <testcase" + class_name + attribute("name", pointer_of_claim(i) + ": " + result.claim);
        if (result.passed) {
            text += "/>\n";
            continue;
        }
        text += "><failure" + attribute("message", moment_text(result) + ": " + result.finding) + "/>";
        if (!check.shots.empty() && !check.shots[i].empty())
            text += "<system-out>drawn: " + escape_markup(check.shots[i].string()) + "</system-out>";
        text += "</testcase>\n";
    }
    return text + "  </testsuite>\n";
}

}  // namespace

SceneCheck check_scene_file(const std::string& file, const LoadOptions& changes) {
    SceneCheck check;
    check.file = file;
    check.name = file_name_of(std::filesystem::path(file).stem().string());
    const Stopwatch watch;
    try {
        run_to_the_end(load_named_scene(file, changes), check);
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

std::string to_junit(const std::vector<SceneCheck>& checks) {
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"tumble\">\n";
    for (const SceneCheck& check : checks) text += junit_suite(check);
    return text + "</testsuites>\n";
}

}  // namespace tumble::tools
