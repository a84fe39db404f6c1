// `tumble import`: a scene from a file of another program.
#include <filesystem>
#include <memory>
#include <string>

#include "command.hpp"
#include "console.hpp"
#include "json_writer.hpp"
#include "output_path.hpp"
#include "tumble/scene.hpp"

namespace tumble::tools {

namespace {

struct ImportArguments {
    std::filesystem::path source;
    std::filesystem::path scene;
    bool force = false;
};

void write_json(const ImportArguments& options, const ImportedScene& imported) {
    JsonWriter json;
    json.open_object().member("scene", options.scene.string());
    json.member("bodies", imported.scene.bodies.size()).member("joints", imported.scene.joints.size());
    json.key("not_carried_over").open_array();
    for (const ImportNote& note : imported.notes)
        json.open_object().member("feature", note.feature).member("count", note.count).close_object();
    json.close_array().close_object();
    write_output(json.text() + "\n");
}

void write_text(const ImportArguments& options, const ImportedScene& imported) {
    write_output(options.scene.string() + ": " + std::to_string(imported.scene.bodies.size()) + " bodies, " +
                 std::to_string(imported.scene.joints.size()) + " joints\n");
    for (const ImportNote& note : imported.notes)
        report_warning("not carried over: " + note.feature + " (" + std::to_string(note.count) + ")");
}

ExitCode import_scene(const Command& command, const ImportArguments& options) {
    refuse_to_overwrite(options.scene, options.force);
    const ImportedScene imported = import_rube(options.source);
    create_folder_of(options.scene);
    save_scene(imported.scene, options.scene);
    if (command.json)
        write_json(options, imported);
    else
        write_text(options, imported);
    return ExitCode::ok;
}

}  // namespace

void add_import(CLI::App& app, Command& command) {
    const auto options = std::make_shared<ImportArguments>();
    CLI::App& app_import = add_subcommand(app, command, "import", "Make a scene from a R.U.B.E. (b2dJson) export");
    app_import.add_option("FILE", options->source, "The export")->required();
    app_import.add_option("-o,--output", options->scene, "Scene file to write")->type_name("SCENE")->required();
    app_import.add_flag("--force", options->force, "Replace the scene file if it exists");
    app_import.callback(
        [&command, options] { command.action = [&command, options] { return import_scene(command, *options); }; });
}

}  // namespace tumble::tools
