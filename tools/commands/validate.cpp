// `tumble validate`: reads scenes, and says everything that is wrong with them.
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "tools/cli/command.hpp"
#include "tools/cli/console.hpp"
#include "tools/cli/error_report.hpp"
#include "tools/output/json_writer.hpp"
#include "tools/scene/scene_options.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::tools {

namespace {

// What is known about one file after reading it.
struct Verdict {
    std::string file;
    ExitCode code = ExitCode::ok;
    std::string error;                    // empty if the scene is valid
    std::vector<Diagnostic> diagnostics;  // errors and warnings
    std::size_t bodies = 0;
    std::size_t joints = 0;
};

struct ValidateArguments {
    std::vector<std::string> files;
    LoadOptions changes;
    bool strict = false;
};

// "3 bodies", "1 joint".
std::string amount(std::size_t count, const std::string& one, const std::string& many) {
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

Verdict judge(const std::string& file, const ValidateArguments& options) {
    Verdict verdict;
    verdict.file = file;
    try {
        LoadOptions changes = options.changes;
        changes.lint = true;
        const Scene scene = load_scene(file, changes, &verdict.diagnostics);
        verdict.bodies = count_bodies(scene);
        verdict.joints = count_joints(scene);
        if (options.strict && !verdict.diagnostics.empty()) verdict.code = ExitCode::invalid_input;
    } catch (const SceneError& error) {
        verdict.code = ExitCode::invalid_input;
        verdict.error = error.what();
        verdict.diagnostics.insert(verdict.diagnostics.begin(), error.diagnostics.begin(), error.diagnostics.end());
    } catch (const FileError& error) {
        verdict.code = ExitCode::file_system;
        verdict.error = error.what();
    }
    return verdict;
}

void say(const Verdict& verdict) {
    for (const Diagnostic& diagnostic : verdict.diagnostics) narrate(to_string(diagnostic) + "\n");
    if (verdict.code == ExitCode::file_system) report_error(verdict.error);
    if (!verdict.error.empty()) return;
    const std::size_t warnings = verdict.diagnostics.size();
    write_output(verdict.file + ": valid, " + amount(verdict.bodies, "body", "bodies") + ", " +
                 amount(verdict.joints, "joint", "joints") +
                 (warnings > 0 ? ", " + amount(warnings, "warning", "warnings") : "") + "\n");
}

void write(JsonWriter& json, const Verdict& verdict) {
    json.open_object().member("file", verdict.file).member("valid", verdict.error.empty());
    if (verdict.code == ExitCode::file_system) json.member("error", verdict.error);
    json.member("bodies", verdict.bodies).member("joints", verdict.joints).key("diagnostics");
    write_diagnostics(json, verdict.diagnostics);
    json.close_object();
}

// An unreadable file weighs more than an invalid one, whatever their order.
ExitCode validate(const Command& command, const ValidateArguments& options) {
    ExitCode code = ExitCode::ok;
    JsonWriter json;
    json.open_object().key("scenes").open_array();
    for (const std::string& file : without_schemas(options.files)) {
        const Verdict verdict = judge(file, options);
        code = std::max(code, verdict.code);
        if (command.json)
            write(json, verdict);
        else
            say(verdict);
    }
    json.close_array().close_object();
    if (command.json) write_output(json.text() + "\n");
    return code;
}

}  // namespace

void add_validate(CLI::App& app, Command& command) {
    const auto options = std::make_shared<ValidateArguments>();
    CLI::App& app_validate = add_subcommand(app, command, "validate", "Say everything that is wrong with scene files");
    app_validate.add_option("SCENE", options->files, "Scene files")->required();
    add_change_options(app_validate, options->changes);
    app_validate.add_flag("--strict", options->strict, "A warning too is exit code 3");
    app_validate.callback(
        [&command, options] { command.action = [&command, options] { return validate(command, *options); }; });
}

}  // namespace tumble::tools
