// `tumble check`: simulates scenes without drawing them, and evaluates their claims ("expect").
#include <CLI/CLI.hpp>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "tools/claims/claim_marks.hpp"
#include "tools/cli/console.hpp"
#include "tools/cli/error_report.hpp"
#include "tools/cli/interrupt.hpp"
#include "tools/cli/output_path.hpp"
#include "tools/cli/validators.hpp"
#include "tools/commands/commands.hpp"
#include "tools/output/json_writer.hpp"
#include "tools/output/standard_input.hpp"
#include "tools/run/run_options.hpp"
#include "tools/scene/check_text.hpp"
#include "tools/scene/hash_update.hpp"
#include "tools/scene/junit.hpp"
#include "tools/scene/scene_check.hpp"
#include "tools/scene/scene_options.hpp"
#include "tools/scene/scene_shot.hpp"
#include "tumble/scene_file.hpp"

namespace tumble::tools {

namespace {

struct CheckArguments {
    std::vector<std::string> files;
    CheckOptions check{.threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()))};
    std::filesystem::path junit;
    std::filesystem::path shots;
    bool force = false;
};

// Such a scene passes if it runs to its end, whatever its bodies do. Its author may not know that.
void warn_of_no_claims(const SceneCheck& check) {
    if (!check.was_simulated || !check.expectations.empty()) return;
    report_warning(check.file +
                   ": the scene has no claims: it passes if it runs to its end. List what must be true in \"expect\"; "
                   "--require-claims refuses such scenes");
}

void write_updates(JsonWriter& json, const SceneCheck& check) {
    if (!check.updated.empty()) {
        json.key("updated").open_array();
        for (const UpdatedHash& hash : check.updated)
            json.open_object()
                .member("pointer", hash.pointer)
                .member("before", hash.before)
                .member("after", hash.after)
                .close_object();
        json.close_array();
    }
    if (!check.pictures.empty()) {
        json.key("pictures").open_array();
        for (const WrittenPicture& picture : check.pictures)
            json.open_object().member("pointer", picture.pointer).member("file", picture.file.string()).close_object();
        json.close_array();
    }
}

void write(JsonWriter& json, const SceneCheck& check) {
    json.open_object().member("file", check.file).member("passed", check.code == ExitCode::ok && !check.was_skipped);
    json.member("skipped", check.was_skipped);
    if (!check.error.empty()) json.member("error", check.error);
    if (!check.failure.empty()) json.member("failure", check.failure);
    json.member("steps", check.steps).member("state_hash", to_hex(check.state_hash)).member("seconds", check.seconds);
    json.key("expectations").open_array();
    for (std::size_t i = 0; i < check.expectations.size(); ++i) {
        const ExpectationResult& result = check.expectations[i];
        json.open_object().member("pointer", pointer_of_claim(i)).member("claim", result.claim);
        json.member("passed", result.passed).member("finding", result.finding);
        json.member("step", result.step).member("time", result.time);
        if (!check.shots.empty() && !check.shots[i].empty()) json.member("shot", check.shots[i].string());
        json.close_object();
    }
    json.close_array();
    write_updates(json, check);
    json.close_object();
}

// Scenes of equal names get a number: x, x-2, x-3.
void make_names_unique(std::vector<SceneCheck>& checks) {
    std::set<std::string> taken;
    for (SceneCheck& check : checks) {
        const std::string name = check.name;
        for (int copy = 2; !taken.insert(check.name).second; ++copy) check.name = name + "-" + std::to_string(copy);
    }
}

// Draws the step that decided each failed claim to DIR/<scene>-expect-<index>.png. A picture that cannot be drawn is a
// warning and does not change the exit code.
void draw_failures(SceneCheck& check, const CheckArguments& options) {
    check.shots.resize(check.expectations.size());
    for (std::size_t i = 0; i < check.expectations.size(); ++i) {
        const ExpectationResult& result = check.expectations[i];
        if (result.passed) continue;
        const std::filesystem::path file = options.shots / (check.name + "-expect-" + std::to_string(i) + ".png");
        try {
            refuse_to_overwrite(file, options.force);
            const Scene scene = load_named_scene(check.file, options.check.changes);
            draw_scene_at(scene, result.step, {.overlay = {.notes = false}, .renderer = options.check.renderer}, file,
                          [&](const SceneWorld& built) { return marks_of(scene.expect.at(i), result, built); });
            check.shots[i] = file;
        } catch (...) {
            report_warning("no picture of a failed claim: " + explain(std::current_exception()).message);
        }
    }
}

// Writes the hashes into the file of the scene. A file that cannot be written is an error of its scene, so that the
// reports of all scenes are still written.
void update(SceneCheck& check) {
    if (!check.was_simulated) return;
    try {
        update_hashes(check);
    } catch (...) {
        const Problem problem = explain(std::current_exception());
        check.code = problem.code;
        check.error = "the hashes could not be written: " + problem.message;
    }
}

// --set and --seed change the scene and its hashes; the file would get the hashes of the changed scene. Standard input
// cannot be written.
void refuse_wrong_update(const CheckArguments& options) {
    if (!options.check.update) return;
    if (!options.check.changes.overrides.empty() || options.check.changes.seed)
        throw CLI::ValidationError(
            "--update", "writes the hashes and pictures of the scenes as they are; leave out --set and --seed");
    if (std::ranges::any_of(options.files, [](const std::string& file) { return is_standard_input(file); }))
        throw CLI::ValidationError("--update", "writes into the scene files, and standard input is none");
}

ExitCode check_all(const Command& command, const CheckArguments& options) {
    refuse_wrong_update(options);
    if (!options.junit.empty()) refuse_to_overwrite(options.junit, options.force);
    catch_interrupts();
    std::vector<SceneCheck> checks = check_scene_files(without_schemas(options.files), options.check);
    // Of different codes, that of an interruption counts most, then the highest other than `failed`, then `failed`.
    const auto weight = [](ExitCode code) { return code == ExitCode::failed ? 1 : static_cast<int>(code) * 10; };
    ExitCode code = ExitCode::ok;
    JsonWriter json;
    json.open_object().key("scenes").open_array();
    if (!options.shots.empty()) make_names_unique(checks);
    for (SceneCheck& check : checks) {
        warn_of_no_claims(check);
        if (options.check.update) update(check);
        if (weight(check.code) > weight(code)) code = check.code;
        if (!options.shots.empty()) draw_failures(check, options);
        command.json ? write(json, check) : write_report(to_text(check));
    }
    json.close_array().member("passed", code == ExitCode::ok).close_object();
    if (command.json) write_output(json.text() + "\n");
    if (!options.junit.empty()) write_file(options.junit, to_junit(checks), options.force);
    return code;
}

}  // namespace

void add_check(CLI::App& app, Command& command) {
    const auto options = std::make_shared<CheckArguments>();
    CLI::App& check = add_subcommand(
        app, command, "check", "Simulate scenes and evaluate their claims (\"expect\"); exit code 7 if one fails");
    check.add_option("SCENE", options->files, "Scene files; - is standard input")->required();
    add_change_options(check, options->check.changes);
    allow_standard_output(
        *check.add_option("--junit", options->junit, "Write the results as JUnit XML")->type_name("F.xml"));
    check.add_option("--shots", options->shots, "Draw the deciding step of each failed claim into this folder")
        ->type_name("DIR")
        ->check(folder_name());
    check.add_flag("--require-claims", options->check.require_claims, "A scene without claims fails");
    check.add_flag("--fail-fast", options->check.stop_at_failure, "Begin no other scene after one that fails");
    check.add_flag(
        "--update", options->check.update,
        "Write the hashes that were found into failed state_hash claims, and missing files of picture claims");
    check.add_option("-j,--jobs", options->check.threads, "Scenes to simulate in parallel")
        ->capture_default_str()
        ->check(whole_number_from_to(1, 256));
    add_renderer_option(check, options->check.renderer);
    check.add_flag("--force", options->force, "Replace existing files");
    check.callback(
        [&command, options] { command.action = [&command, options] { return check_all(command, *options); }; });
}

}  // namespace tumble::tools
