// `tumble shrink`: makes a scene smaller while it fails in the same way.
#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "tools/cli/console.hpp"
#include "tools/cli/interrupt.hpp"
#include "tools/cli/output_path.hpp"
#include "tools/cli/validators.hpp"
#include "tools/commands/commands.hpp"
#include "tools/machine/build_info.hpp"
#include "tools/output/input_error.hpp"
#include "tools/output/json_writer.hpp"
#include "tools/output/number_text.hpp"
#include "tools/output/temporary_folder.hpp"
#include "tools/run/run_options.hpp"
#include "tools/scene/scene_options.hpp"
#include "tools/shrink/failure_picture.hpp"
#include "tools/shrink/shrinker.hpp"
#include "tools/shrink/trial_log.hpp"
#include "tumble/scene_file.hpp"

namespace tumble::tools {

namespace {

namespace fs = std::filesystem;

struct ShrinkArguments {
    SceneOptions scene;
    TrialSettings trial;
    std::optional<int> claim;
    std::vector<std::string> keep;
    fs::path output;
    int jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    RenderBackend renderer = RenderBackend::automatic;
    bool force = false;
};

struct OutputFiles {
    fs::path scene, picture, log;
};

// A folder in which candidates are written for the command, removed at the end.
struct Shrunk {
    SceneSize before, after;
    std::string failure;
    std::size_t runs = 0, new_runs = 0;
    bool complete = false;
    bool has_picture = false;
};

OutputFiles output_files(const ShrinkArguments& options, const Scene& scene) {
    const bool is_file = options.output.extension() == ".json";
    const fs::path stem =
        is_file ? fs::path(options.output).replace_extension() : options.output / file_name_of(scene.name);
    return {stem.string() + ".json", stem.string() + ".png", stem.string() + ".shrink.log"};
}

void check_arguments(const ShrinkArguments& options, const Scene& scene) {
    const TrialSettings& trial = options.trial;
    if (options.output == "-" || is_standard_output(options.output))
        throw CLI::ValidationError(
            "--output",
            "must be a file or a folder: the picture and the log, from which the search continues, are beside it");
    if (!trial.is_check() && trial.command.find("{}") == std::string::npos)
        throw CLI::ValidationError("--fails", "must be check, or a command with {} in place of the scene's file");
    if (trial.is_check() && trial.same_output)
        throw CLI::ValidationError("--same-output", "is for commands of --fails");
    if (!trial.is_check() && trial.any_body) throw CLI::ValidationError("--any-body", "is for --fails check");
    if (!trial.is_check() && options.claim) throw CLI::ValidationError("--claim", "is for --fails check");
    if (options.claim && static_cast<std::size_t>(*options.claim) >= scene.expect.size())
        throw CLI::ValidationError("--claim", "there is no claim /expect/" + std::to_string(*options.claim) +
                                                  "; the scene has " + std::to_string(scene.expect.size()));
    for (const std::string& name : options.keep)
        if (std::ranges::find(scene.bodies, name, &SceneBody::name) == scene.bodies.end())
            throw CLI::ValidationError("--keep", "there is no body '" + name + "'");
}

// A command gets candidates in another folder, where the files that these claims name are not. `check` does not decide
// them.
void drop_claims_on_files(Scene& scene) {
    std::erase_if(scene.expect,
                  [](const SceneExpectation& claim) { return !claim.picture.empty() || !claim.reference.empty(); });
}

// What decides the results of the runs besides their candidates.
std::uint64_t task_of(const ShrinkArguments& options, const std::string& text) {
    std::string task = text + '\n' + options.trial.command + '\n' + std::to_string(options.trial.timeout) +
                       (options.trial.same_output ? " same output " : " ") +
                       (options.trial.any_body ? "any body " : "") + std::to_string(options.claim.value_or(-1));
    for (const std::string& name : options.keep) task += '\n' + name;
    if (options.trial.is_check()) {
        // Another build may give other results.
        std::error_code unknown;
        const fs::path binary = fs::read_symlink("/proc/self/exe", unknown);
        task += '\n' + std::to_string(fs::file_size(binary, unknown)) + ' ' +
                std::to_string(fs::last_write_time(binary, unknown).time_since_epoch().count());
    }
    return hash_of(task);
}

Failure chosen_failure(const ShrinkArguments& options, const std::vector<Failure>& failures) {
    const std::string& file = options.scene.file;
    if (options.claim) {
        const auto found = std::ranges::find(failures, *options.claim, &Failure::claim);
        if (found == failures.end())
            throw InputError(file + ": the claim /expect/" + std::to_string(*options.claim) +
                             " does not fail, or is one on a state hash, a picture or the wall clock");
        return *found;
    }
    if (!failures.empty()) {
        const std::string& text = failures.front().text;
        if (!options.trial.is_check() && (text.starts_with("exit code 126") || text.starts_with("exit code 127")))
            throw CLI::ValidationError("--fails", "the shell cannot run this command: " + text);
        return failures.front();
    }
    if (options.trial.is_check())
        throw InputError(file +
                         ": the scene does not fail: it was simulated to its end, and its claims hold. Claims on state "
                         "hashes, pictures and the wall clock do not count; --fails \"CMD {}\" runs a command instead");
    throw InputError(file + ": the scene does not fail: its canonical form was given to '" + options.trial.command +
                     "', which ended with exit code 0");
}

std::string arrow(const char* unit, std::size_t before, std::size_t after) {
    return std::to_string(before) + " " + unit + " -> " + std::to_string(after);
}

std::string summary(const Shrunk& shrunk, const OutputFiles& files) {
    const SceneSize &before = shrunk.before, &after = shrunk.after;
    std::string durations;
    append_number(durations, before.duration);
    append_number(durations += " s -> ", after.duration);
    return files.scene.string() + ": " + arrow("bodies", before.bodies, after.bodies) + ", " +
           arrow("joints", before.joints, after.joints) + ", " + arrow("shapes", before.shapes, after.shapes) + ", " +
           arrow("events", before.events, after.events) + ", " + durations + " s, " +
           arrow("bytes", before.bytes, after.bytes) + ", " + counted(shrunk.runs, "run") + "\n" +
           "it still fails: " + shrunk.failure + "\n";
}

void write(JsonWriter& json, const char* key, const SceneSize& size) {
    json.key(key).open_object();
    json.member("bodies", size.bodies).member("joints", size.joints).member("shapes", size.shapes);
    json.member("events", size.events).member("claims", size.claims).member("duration", size.duration);
    json.member("bytes", size.bytes).close_object();
}

void report(const Command& command, const Shrunk& shrunk, const OutputFiles& files) {
    if (!command.json) {
        write_report(summary(shrunk, files));
        return;
    }
    JsonWriter json;
    json.open_object().member("file", files.scene.string());
    if (shrunk.has_picture) json.member("picture", files.picture.string());
    json.member("failure", shrunk.failure).member("complete", shrunk.complete);
    write(json, "before", shrunk.before);
    write(json, "after", shrunk.after);
    json.member("runs", shrunk.runs).member("new_runs", shrunk.new_runs).close_object();
    write_output(json.text() + "\n");
}

void draw(const Shrinker& shrinker, Failure failure, const OutputFiles& files, RenderBackend renderer, Shrunk& shrunk) {
    failure.step = shrinker.step();
    if (failure.claim >= 0) failure.claim = 0;  // the others have been removed
    const std::string error = draw_failure(shrinker.scene(), failure, files.picture, renderer);
    shrunk.has_picture = error.empty();
    if (!error.empty()) report_warning("no picture of the failure: " + error);
}

ExitCode shrink(const Command& command, const ShrinkArguments& options) {
    Scene scene = read_scene(options.scene);
    check_arguments(options, scene);
    if (!options.trial.is_check()) drop_claims_on_files(scene);
    scene.draws.clear();  // the numbers that were drawn stay
    const std::string text = to_json(scene);
    const OutputFiles files = output_files(options, scene);
    const std::uint64_t task = task_of(options, text);
    const bool continues = !options.force && TrialLog::exists(files.log, task);
    for (const fs::path& file : {files.scene, files.picture}) refuse_to_overwrite(file, options.force || continues);

    catch_interrupts();
    const TemporaryFolder folder("shrink");
    const std::vector<Failure> failures = run_trial(text, options.trial, folder.path() / "0" / "scene.json");
    if (is_interrupted()) return interruption_code();
    const Failure failure = chosen_failure(options, failures);
    narrate_progress("it fails: " + failure.text + "\n");

    TrialLog log(files.log, task, options.force);
    Candidates candidates(options.trial, failure.text, options.jobs, folder.path(), log);
    Shrinker shrinker(
        text, failure, options.keep, candidates,
        [&](const std::string& smaller) { write_file(files.scene, smaller, true); },
        [&](const std::string& change) {
            narrate_progress(change + ", " + counted(candidates.run_count(), "run") + "\n");
        });
    Shrunk shrunk{size_of(scene), {}, failure.text};
    try {
        shrinker.shrink();
        shrunk.complete = true;
        draw(shrinker, failure, files, options.renderer, shrunk);
    } catch (const SearchInterrupted&) {
        report_warning("interrupted: the smallest scene so far is " + files.scene.string() +
                       "; the same command continues");
    }
    shrunk.after = size_of(shrinker.scene());
    shrunk.runs = candidates.run_count();
    shrunk.new_runs = candidates.new_run_count();
    report(command, shrunk, files);
    return shrunk.complete && !is_interrupted() ? ExitCode::ok : interruption_code();
}

}  // namespace

void add_shrink(CLI::App& app, Command& command) {
    const auto options = std::make_shared<ShrinkArguments>();
    CLI::App& shrink_command = add_subcommand(
        app, command, "shrink", "Remove from a failing scene what the failure does not need, and draw the failure");
    add_scene_options(shrink_command, options->scene);
    shrink_command
        .add_option("--fails", options->trial.command,
                    "What fails: check, or a command of the shell with {} for the file of the scene")
        ->type_name("\"CMD {}\"")
        ->capture_default_str();
    shrink_command
        .add_option("--claim", options->claim, "The claim to fail, by its index; default: the first that fails")
        ->type_name("N")
        ->check(whole_number_from_to(0, 1000000));
    shrink_command.add_flag("--same-output", options->trial.same_output,
                            "With a command: keep the first line of its standard error too");
    shrink_command.add_flag("--any-body", options->trial.any_body,
                            "With a claim: the finding may name other bodies and joints");
    shrink_command.add_option("--keep", options->keep, "Do not remove this body; repeatable")
        ->type_name("BODY")
        ->allow_extra_args(false);
    shrink_command.add_option("--timeout", options->trial.timeout, "Seconds after which a run is ended, and fails")
        ->type_name("S")
        ->capture_default_str()
        ->check(number_from_to(0.01, 1e6));
    shrink_command
        .add_option("-o,--output", options->output,
                    "Scene file to write, *.json, or a folder; the picture and the log are beside it")
        ->type_name("FILE|DIR")
        ->check(file_name())
        ->required();
    shrink_command.add_option("-j,--jobs", options->jobs, "Runs at a time")
        ->capture_default_str()
        ->check(whole_number_from_to(1, 256));
    add_renderer_option(shrink_command, options->renderer);
    shrink_command.add_flag("--force", options->force, "Replace existing files, and start from the beginning");
    shrink_command.callback(
        [&command, options] { command.action = [&command, options] { return shrink(command, *options); }; });
}

}  // namespace tumble::tools
