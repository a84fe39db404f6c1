// `tumble validate`: reads scenes, and says everything that is wrong with them.
#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "command.hpp"
#include "console.hpp"
#include "error_report.hpp"
#include "json_writer.hpp"
#include "scene_options.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::tools {

namespace {

// What is known about one file after reading it.
struct Verdict {
    std::string file;
    ExitCode code = ExitCode::ok;
    std::string error;                     // empty if the scene is valid
    std::vector<Diagnostic> diagnostics;   // errors and warnings
    std::size_t bodies = 0;
    std::size_t joints = 0;
};

Verdict judge(const std::string& file) {
    Verdict verdict;
    verdict.file = file;
    try {
        const Scene scene = load_scene(file, {.overrides = {}, .seed = {}, .lint = true}, &verdict.diagnostics);
        verdict.bodies = count_bodies(scene);
        verdict.joints = count_joints(scene);
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
    if (verdict.code == ExitCode::ok)
        write_output(verdict.file + ": valid, " + std::to_string(verdict.bodies) + " bodies, " +
                     std::to_string(verdict.joints) + " joints\n");
}

void write(JsonWriter& json, const Verdict& verdict) {
    json.open_object().member("file", verdict.file).member("valid", verdict.code == ExitCode::ok);
    if (verdict.code == ExitCode::file_system) json.member("error", verdict.error);
    json.member("bodies", verdict.bodies).member("joints", verdict.joints).key("diagnostics");
    write_diagnostics(json, verdict.diagnostics);
    json.close_object();
}

// An unreadable file weighs more than an invalid one, whatever their order.
ExitCode validate(const Command& command, const std::vector<std::string>& files) {
    ExitCode code = ExitCode::ok;
    JsonWriter json;
    json.open_object().key("scenes").open_array();
    for (const std::string& file : without_schemas(files)) {
        const Verdict verdict = judge(file);
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
    const auto files = std::make_shared<std::vector<std::string>>();
    CLI::App& app_validate = add_subcommand(app, command, "validate", "Say everything that is wrong with scene files");
    app_validate.add_option("SCENE", *files, "Scene files")->required();
    app_validate.callback(
        [&command, files] { command.action = [&command, files] { return validate(command, *files); }; });
}

}  // namespace tumble::tools
