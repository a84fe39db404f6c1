// `tumble demo`: a shipped scene, run into a folder of the build, which the demo owns and replaces.
#include <filesystem>
#include <memory>
#include <string>

#include "command.hpp"
#include "console.hpp"
#include "json_writer.hpp"
#include "places.hpp"
#include "run_report.hpp"
#include "scene_options.hpp"
#include "simulation.hpp"

namespace tumble::tools {

namespace fs = std::filesystem;

namespace {

constexpr const char* kDefaultDemo = "mixed_rain";

struct DemoArguments {
    std::string name = kDefaultDemo;
    bool list = false;
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
    for (const fs::path& file : find_scenes())
        if (file.stem() == name) return file;
    throw CLI::ValidationError("NAME", "there is no shipped scene '" + name + "'; demo --list shows which there are");
}

ExitCode run_demo(const Command& command, const DemoArguments& options) {
    SceneOptions source;
    source.file = find_demo(options.name).string();
    const Scene scene = read_scene(source);
    RunOptions settings;
    settings.folder = demo_folder() / file_name_of(scene, source.file);
    settings.force = true;
    narrate("Simulating and rendering " + options.name + ": " + scene.description + "\n");
    const RunReport report = simulate(scene, settings);
    if (command.json) {
        write_output(to_json(report));
    } else {
        const std::string tumble = command_to_type();
        write_output(to_text(report));
        write_output("  next        " + tumble + " demo --list, or one frame of another scene:\n              " +
                     tumble + " shot " + find_scene("bridge").string() + " --at 2 -o bridge.png\n");
    }
    return report.complete ? ExitCode::ok : ExitCode::interrupted;
}

}  // namespace

void add_demo(CLI::App& app, Command& command) {
    const auto options = std::make_shared<DemoArguments>();
    CLI::App& demo = add_subcommand(app, command, "demo", "Run a shipped scene into the build folder");
    demo.add_option("NAME", options->name, "The scene")->capture_default_str();
    demo.add_flag("--list", options->list, "List the shipped scenes");
    demo.callback([&command, options] {
        command.action = [&command, options] {
            return options->list ? list_demos(command) : run_demo(command, *options);
        };
    });
}

}  // namespace tumble::tools
