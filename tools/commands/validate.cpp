// `tumble validate`: reads scenes and reports all their errors and warnings.
#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "tools/cli/console.hpp"
#include "tools/cli/error_report.hpp"
#include "tools/commands/commands.hpp"
#include "tools/output/json_writer.hpp"
#include "tools/output/number_text.hpp"
#include "tools/output/standard_input.hpp"
#include "tools/scene/scene_options.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::tools {

namespace {

// The result of reading one file.
struct Validation {
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

Validation validate_file(const std::string& file, const ValidateArguments& options) {
    Validation validation;
    validation.file = file;
    try {
        LoadOptions changes = options.changes;
        changes.lint = true;
        const Scene scene = load_scene_input(file, changes, &validation.diagnostics);
        validation.bodies = count_bodies(scene);
        validation.joints = count_joints(scene);
        if (options.strict && !validation.diagnostics.empty()) validation.code = ExitCode::invalid_input;
    } catch (const SceneError& error) {
        validation.code = code_of(error);
        validation.error = error.what();
        validation.diagnostics.insert(validation.diagnostics.begin(), error.diagnostics.begin(),
                                      error.diagnostics.end());
    } catch (const FileError& error) {
        validation.code = ExitCode::file_system;
        validation.error = error.what();
    }
    return validation;
}

void print(const Validation& validation) {
    for (const Diagnostic& diagnostic : validation.diagnostics) narrate(to_string(diagnostic) + "\n");
    if (validation.code == ExitCode::file_system) report_error(validation.error);
    if (!validation.error.empty()) return;
    const std::size_t warnings = validation.diagnostics.size();
    write_report(validation.file + ": valid, " + counted(validation.bodies, "body") + ", " +
                 counted(validation.joints, "joint") + (warnings > 0 ? ", " + counted(warnings, "warning") : "") +
                 "\n");
}

void write(JsonWriter& json, const Validation& validation) {
    json.open_object().member("file", validation.file).member("valid", validation.error.empty());
    if (validation.code == ExitCode::file_system) json.member("error", validation.error);
    json.member("bodies", validation.bodies).member("joints", validation.joints).key("diagnostics");
    write_diagnostics(json, validation.diagnostics);
    json.close_object();
}

// The exit code reports an unreadable file before an invalid one, independent of their order.
ExitCode validate(const Command& command, const ValidateArguments& options) {
    ExitCode code = ExitCode::ok;
    JsonWriter json;
    json.open_object().key("scenes").open_array();
    for (const std::string& file : without_schemas(options.files)) {
        const Validation validation = validate_file(file, options);
        code = std::max(code, validation.code);
        if (command.json)
            write(json, validation);
        else
            print(validation);
    }
    json.close_array().close_object();
    if (command.json) write_output(json.text() + "\n");
    return code;
}

}  // namespace

void add_validate(CLI::App& app, Command& command) {
    const auto options = std::make_shared<ValidateArguments>();
    CLI::App& app_validate = add_subcommand(app, command, "validate", "Report all errors and warnings of scene files");
    app_validate.add_option("SCENE", options->files, "Scene files; - is standard input")->required();
    add_change_options(app_validate, options->changes);
    app_validate.add_flag("--strict", options->strict, "Exit code 3 for warnings too");
    app_validate.callback(
        [&command, options] { command.action = [&command, options] { return validate(command, *options); }; });
}

}  // namespace tumble::tools
