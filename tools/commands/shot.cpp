// `tumble shot`: renders one frame of a scene.
#include <CLI/CLI.hpp>

#include <cstdint>
#include <filesystem>
#include <memory>

#include "tools/cli/console.hpp"
#include "tools/cli/output_path.hpp"
#include "tools/cli/validators.hpp"
#include "tools/commands/commands.hpp"
#include "tools/output/json_writer.hpp"
#include "tools/run/frame_views.hpp"
#include "tools/run/run_options.hpp"
#include "tools/scene/scene_options.hpp"
#include "tools/scene/scene_shot.hpp"

namespace tumble::tools {

namespace {

struct ShotArguments {
    SceneOptions scene;
    double time = 0.0;
    std::filesystem::path file;
    ShotSettings settings;
    bool force = false;
};

void report_shot(const Command& command, const ShotArguments& options, const SceneShot& shot) {
    if (!command.json) {
        write_report(options.file.string() + "\n");
        return;
    }
    JsonWriter json;
    const SceneRun& run = shot.run;
    json.open_object().member("file", options.file.string()).member("step", run.world().step_count());
    json.member("time", run.time()).member("state_hash", to_hex(run.world().state_hash())).key("view");
    write_view(json, options.settings.size, view_of(shot.camera, options.settings.size, 0));
    json.close_object();
    write_output(json.text() + "\n");
}

ExitCode shoot(const Command& command, const ShotArguments& options) {
    if (!is_standard_output(options.file) && options.file.extension() != ".png")
        throw CLI::ValidationError("--output", "expected a file name that ends in .png, got " + options.file.string());
    const Scene scene = read_scene(options.scene);
    if (options.time > scene.world.duration)
        report_warning("--at is after the end of the scene; the simulation continues until then");
    refuse_to_overwrite(options.file, options.force);
    const std::uint64_t step = nearest_step(options.time, scene.world.steps_per_second);
    report_shot(command, options, draw_scene_at(scene, step, options.settings, options.file));
    return ExitCode::ok;
}

}  // namespace

void add_shot(CLI::App& app, Command& command) {
    const auto options = std::make_shared<ShotArguments>();
    CLI::App& shot = add_subcommand(app, command, "shot", "Render one frame of a scene");
    add_scene_options(shot, options->scene);
    shot.add_option("--at", options->time, "Simulated time of the frame in seconds")
        ->type_name("T")
        ->capture_default_str()
        ->check(number_from_to(0.0, kMaxDuration));
    allow_standard_output(*shot.add_option("-o,--output", options->file, "PNG file to write; - is standard output")
                               ->type_name("F.png")
                               ->required());
    add_size_option(shot, options->settings.size);
    add_overlay_option(shot, options->settings.overlay);
    add_renderer_option(shot, options->settings.renderer);
    shot.add_flag("--force", options->force, "Replace the file if it exists");
    shot.callback([&command, options] { command.action = [&command, options] { return shoot(command, *options); }; });
}

}  // namespace tumble::tools
