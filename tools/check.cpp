// `tumble check`: simulate scenes without drawing them, and test what they claim about themselves.
#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "command.hpp"
#include "console.hpp"
#include "interrupt.hpp"
#include "json_writer.hpp"
#include "output_path.hpp"
#include "scene_check.hpp"
#include "scene_options.hpp"
#include "scene_shot.hpp"
#include "tumble/scene_file.hpp"

namespace tumble::tools {

namespace {

struct CheckArguments {
    std::vector<std::string> files;
    LoadOptions changes;
    std::filesystem::path junit;
    std::filesystem::path shots;
    int jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    bool force = false;
};

std::string verdict_line(const SceneCheck& check) {
    const auto passed = std::ranges::count(check.expectations, true, &ExpectationResult::passed);
    if (!check.error.empty()) return check.file + ": not run to its end\n";
    if (check.expectations.empty()) return check.file + ": runs, claims nothing\n";
    return check.file + ": " + std::to_string(passed) + " of " + std::to_string(check.expectations.size()) +
           " claims hold\n";
}

void say(const SceneCheck& check) {
    write_output(verdict_line(check));
    if (!check.error.empty()) report_error(check.error);
    for (std::size_t i = 0; i < check.expectations.size(); ++i) {
        const ExpectationResult& result = check.expectations[i];
        if (result.passed) continue;
        narrate("  /expect/" + std::to_string(i) + " failed: expected that " + result.claim + "\n    at step " +
                std::to_string(result.step) + ": " + result.finding + "\n");
    }
}

void write(JsonWriter& json, const SceneCheck& check) {
    json.open_object().member("file", check.file).member("passed", check.code == ExitCode::ok);
    if (!check.error.empty()) json.member("error", check.error);
    json.member("steps", check.steps).member("state_hash", to_hex(check.state_hash)).member("seconds", check.seconds);
    json.key("expectations").open_array();
    for (std::size_t i = 0; i < check.expectations.size(); ++i) {
        const ExpectationResult& result = check.expectations[i];
        json.open_object().member("pointer", "/expect/" + std::to_string(i)).member("claim", result.claim);
        json.member("passed", result.passed).member("finding", result.finding).member("step", result.step);
        json.close_object();
    }
    json.close_array().close_object();
}

// A picture of the moment that decided each claim that does not hold: DIR/<scene>-expect-<index>.png.
void draw_failures(const SceneCheck& check, const CheckArguments& options) {
    for (std::size_t i = 0; i < check.expectations.size(); ++i) {
        const ExpectationResult& result = check.expectations[i];
        if (result.passed) continue;
        const Scene scene = load_scene(check.file, options.changes);
        const std::filesystem::path file =
            options.shots / (file_name_of(scene, check.file) + "-expect-" + std::to_string(i) + ".png");
        refuse_to_overwrite(file, options.force);
        draw_scene_at(scene, result.step, {}, file);
        narrate("    drawn: " + file.string() + "\n");
    }
}

ExitCode check_all(const Command& command, const CheckArguments& options) {
    if (!options.junit.empty()) refuse_to_overwrite(options.junit, options.force);
    catch_interrupts();
    const std::vector<SceneCheck> checks = check_scene_files(without_schemas(options.files), options.changes, options.jobs);
    // An interruption weighs most, then a scene that could not be read or run, then a claim that does not hold.
    const auto weight = [](ExitCode code) { return code == ExitCode::failed ? 1 : static_cast<int>(code) * 10; };
    ExitCode code = ExitCode::ok;
    JsonWriter json;
    json.open_object().key("scenes").open_array();
    for (const SceneCheck& check : checks) {
        if (weight(check.code) > weight(code)) code = check.code;
        command.json ? write(json, check) : say(check);
        if (!options.shots.empty()) draw_failures(check, options);
    }
    json.close_array().member("passed", code == ExitCode::ok).close_object();
    if (command.json) write_output(json.text() + "\n");
    if (!options.junit.empty()) {
        OutputFile file = open_output(options.junit, options.force);
        file.write(to_junit(checks));
        file.commit();
    }
    return code;
}

}  // namespace

void add_check(CLI::App& app, Command& command) {
    const auto options = std::make_shared<CheckArguments>();
    CLI::App& check = add_subcommand(app, command, "check", "Simulate scenes, and test what they claim (\"expect\")");
    check.add_option("SCENE", options->files, "Scene files")->required();
    add_change_options(check, options->changes);
    check.add_option("--junit", options->junit, "Write the results as JUnit XML")->type_name("F.xml");
    check.add_option("--shots", options->shots, "Draw the moment of each failure into this folder")->type_name("DIR");
    check.add_option("-j,--jobs", options->jobs, "Scenes at a time")->capture_default_str()->check(CLI::Range(1, 256));
    check.add_flag("--force", options->force, "Replace files that exist");
    check.callback([&command, options] { command.action = [&command, options] { return check_all(command, *options); }; });
}

}  // namespace tumble::tools
