// `tumble run`: simulates a scene, renders its frames and writes the requested files.
#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "tools/cli/console.hpp"
#include "tools/cli/interrupt.hpp"
#include "tools/commands/commands.hpp"
#include "tools/run/run_options.hpp"
#include "tools/run/run_report.hpp"
#include "tools/run/simulation.hpp"
#include "tools/scene/scene_options.hpp"

namespace tumble::tools {

namespace {

struct RunArguments {
    SceneOptions scene;
    RunOptions run;
};

ExitCode run(const Command& command, const RunArguments& options) {
    const Scene scene = read_scene(options.scene);
    const bool has_bodies = !scene.bodies.empty() || std::ranges::any_of(scene.timeline, [](const SceneEvent& event) {
        return event.spawn.has_value();
    });
    if (!has_bodies) report_warning("the scene has no bodies: the frames will be empty");
    RunOptions settings = options.run;
    if (settings.folder.empty()) settings.folder = std::filesystem::path("out") / file_name_of(scene.name);
    const RunReport report = simulate(scene, settings);
    command.json ? write_output(to_json(report)) : write_report(to_text(report));
    if (!report.complete) return interruption_code();
    const bool has_findings = report.health && !report.health->findings.empty();
    return settings.fail_on_findings && has_findings ? ExitCode::failed : ExitCode::ok;
}

}  // namespace

void add_run(CLI::App& app, Command& command) {
    const auto options = std::make_shared<RunArguments>();
    CLI::App& run_app = add_subcommand(app, command, "run", "Simulate a scene, render its frames, write its data");
    add_scene_options(run_app, options->scene);
    add_run_options(run_app, options->run);
    run_app.callback([&command, options] { command.action = [&command, options] { return run(command, *options); }; });
}

}  // namespace tumble::tools
