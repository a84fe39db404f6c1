// `tumble demo`: runs a shipped scene and writes its results to a folder that each demo replaces, or to a folder that
// the user names; lists the shipped scenes; prints the file of one.
#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "tools/cli/console.hpp"
#include "tools/cli/interrupt.hpp"
#include "tools/cli/output_path.hpp"
#include "tools/commands/commands.hpp"
#include "tools/output/json_writer.hpp"
#include "tools/run/run_report.hpp"
#include "tools/run/simulation.hpp"
#include "tools/scene/data_paths.hpp"
#include "tools/scene/scene_options.hpp"
#include "tumble/file.hpp"
#include "tumble/suggest.hpp"

namespace tumble::tools {

namespace fs = std::filesystem;

namespace {

constexpr const char* kDefaultDemo = "mixed_rain";

struct DemoArguments {
    std::string name = kDefaultDemo;
    fs::path folder;
    bool list = false;
    bool print = false;
    RenderBackend renderer = RenderBackend::automatic;
    bool force = false;
};

ExitCode list_demos(const Command& command) {
    JsonWriter json;
    json.open_array();
    for (const fs::path& file : find_scenes()) {
        const std::string name = file.stem().string();
        const Scene scene = load_scene(file);
        json.open_object().member("name", name).member("description", scene.description);
        json.member("file", file.string()).close_object();
        const std::string gap(name.size() < 18 ? 18 - name.size() : 1, ' ');
        if (!command.json) write_output(name + gap + scene.description + "\n");
    }
    json.close_array();
    if (command.json) write_output(json.text() + "\n");
    return ExitCode::ok;
}

fs::path find_demo(const std::string& name) {
    std::vector<std::string> names;
    for (const fs::path& file : find_scenes()) {
        if (file.stem() == name) return file;
        names.push_back(file.stem().string());
    }
    const std::string_view nearest = nearest_word(name, std::vector<std::string_view>(names.begin(), names.end()));
    throw CLI::ValidationError("NAME", "there is no shipped scene '" + name + "'; " +
                                           (nearest.empty() ? "" : "did you mean '" + std::string(nearest) + "'? ") +
                                           "'tumble demo --list' lists all");
}

// Prints the file as it is, with comments. A scene with includes is printed as one scene, because the included files
// are not beside the copy.
ExitCode print_demo(const Command& command, const DemoArguments& options) {
    const fs::path file = find_demo(options.name);
    LoadOptions as_written;
    as_written.keep_includes = true;
    const bool is_one_file = load_scene(file, as_written).include.empty();
    const std::string text = is_one_file ? read_file(file) : to_json(load_scene(file));
    if (!command.json) {
        write_output(text);
        return ExitCode::ok;
    }
    JsonWriter json;
    json.open_object().member("name", options.name).member("file", file.string()).member("text", text).close_object();
    write_output(json.text() + "\n");
    return ExitCode::ok;
}

ExitCode run_demo(const Command& command, const DemoArguments& options) {
    SceneOptions source;
    source.file = find_demo(options.name).string();
    const Scene scene = read_scene(source);
    RunOptions settings;
    const bool is_demo_folder = options.folder.empty();
    settings.folder = is_demo_folder ? demo_folder() / file_name_of(scene.name) : options.folder;
    settings.force = is_demo_folder || options.force;
    settings.renderer = options.renderer;
    narrate_progress("simulating and rendering " + options.name + ": " + scene.description + "\n");
    const RunReport report = simulate(scene, settings);
    if (command.json) {
        write_output(to_json(report));
    } else {
        const std::string tumble = command_to_type();
        write_report(to_text(report));
        write_report("  next        " + tumble + " demo --list, or draw one frame of another scene:\n              " +
                     tumble + " shot " + find_scene("bridge").string() + " --at 2 -o bridge.png\n");
    }
    return report.complete ? ExitCode::ok : interruption_code();
}

}  // namespace

void add_demo(CLI::App& app, Command& command) {
    const auto options = std::make_shared<DemoArguments>();
    CLI::App& demo = add_subcommand(app, command, "demo", "Run a shipped scene");
    demo.add_option("NAME", options->name, "Name of the scene")->capture_default_str();
    demo.add_flag("--list", options->list, "List the shipped scenes");
    demo.add_flag("--print", options->print, "Print the scene file instead of running it, as a start for your own");
    demo.add_option("-o,--output", options->folder, "Folder for the results; default: a folder that each demo replaces")
        ->type_name("DIR")
        ->check(folder_name());
    add_renderer_option(demo, options->renderer);
    demo.add_flag("--force", options->force, "Replace the results of an earlier run in DIR");
    demo.callback([&command, options] {
        command.action = [&command, options] {
            if (options->list) return list_demos(command);
            return options->print ? print_demo(command, *options) : run_demo(command, *options);
        };
    });
}

}  // namespace tumble::tools
