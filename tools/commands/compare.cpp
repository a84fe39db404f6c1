// `tumble compare`: two runs, or a scene in tumble and in Box2D, side by side: a page, a table, frames, a video.
#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tools/cli/console.hpp"
#include "tools/cli/interrupt.hpp"
#include "tools/cli/output_path.hpp"
#include "tools/cli/validators.hpp"
#include "tools/commands/commands.hpp"
#include "tools/compare/compared_frames.hpp"
#include "tools/compare/compared_page.hpp"
#include "tools/compare/compared_player.hpp"
#include "tools/compare/compared_runs.hpp"
#include "tools/diff/diff_report.hpp"
#include "tools/diff/input_kind.hpp"
#include "tools/output/json_writer.hpp"
#include "tools/output/number_text.hpp"
#include "tools/run/run_folder.hpp"
#include "tools/run/run_options.hpp"
#include "tools/scene/scene_options.hpp"
#include "tumble/recording.hpp"

namespace tumble::tools {

namespace {

struct CompareArguments {
    std::string a, b, engine;
    LoadOptions changes;
    std::optional<double> duration;
    std::optional<double> tolerance;
    std::filesystem::path page, csv, frames, video;
    double frames_per_second = 30.0;
    FrameSize size{640, 360};
    Overlay overlay;
    RenderBackend renderer = RenderBackend::automatic;
    bool is_overlaid = false;
    bool force = false;

    bool wants_frames() const { return !frames.empty() || !video.empty(); }
};

// Engines round differently from the first step on, so that the first difference tells nothing.
double tolerance_of(const CompareArguments& options) {
    return options.tolerance.value_or(options.engine.empty() ? 0.0 : 0.01);
}

void require_runs(const std::string& name) {
    const InputKind kind = kind_of(name);
    if (kind != InputKind::states)
        throw CLI::ValidationError("A and B",
                                   "must be scenes or trajectories, and " + name + " is " + std::string(name_of(kind)));
}

CompareInputs inputs_of(const CompareArguments& options) {
    const bool is_of_engines = !options.engine.empty();
    if (is_of_engines == !options.b.empty())
        throw CLI::ValidationError("B", is_of_engines ? "is no input where one scene runs in two engines"
                                                      : "is missing: name a second run, or --engine box2d");
    require_runs(options.a);
    if (!is_of_engines) require_runs(options.b);
    if (is_of_engines && !is_scene_file(options.a))
        throw CLI::ValidationError("--engine", "needs a scene, and " + options.a + " is a table");
    const bool is_changed = !options.changes.overrides.empty() || options.changes.seed;
    if (is_changed && !is_of_engines && !is_scene_file(options.b))
        throw CLI::ValidationError("--set and --seed", "change the scene B, and B is not a scene: " + options.b);
    LoadOptions unchanged;
    unchanged.allow_outside = options.changes.allow_outside;
    CompareInputs inputs{options.a, options.b, is_of_engines ? options.changes : unchanged, options.changes};
    if (options.duration) {
        std::string change = "/world/duration=";
        append_number(change, *options.duration);
        for (LoadOptions* const changes : {&inputs.changes_a, &inputs.changes_b}) changes->overrides.push_back(change);
    }
    return inputs;
}

// All that can be refused is refused before anything is simulated.
void refuse_wrong_outputs(const CompareArguments& options, const CompareInputs& inputs) {
    if (options.page.empty() && options.csv.empty() && !options.wants_frames())
        throw CLI::ValidationError("--output",
                                   "is missing: name a page (-o F.html), a table (--csv), a video (--video) or a "
                                   "folder (--frames); tumble diff compares without one");
    const bool are_scenes = is_scene_file(inputs.a) && (inputs.b.empty() || is_scene_file(inputs.b));
    if (options.wants_frames() && !are_scenes)
        throw CLI::ValidationError("--frames and --video", "need two scenes: a table has no shapes to draw");
    const std::array<std::filesystem::path, 3> files{options.page, options.csv, options.video};
    require_different_names(files);
    for (const std::filesystem::path& file : files)
        if (!file.empty()) refuse_to_overwrite(file, options.force);
    if (!options.frames.empty()) refuse_used_folder(options.frames, options.force);
}

std::vector<PairPicture> draw_moments(const CompareInputs& inputs, const std::vector<Moment>& moments,
                                      const PairPictures& pictures) {
    std::vector<PairPicture> drawn;
    const auto is_wanted = [&](std::uint64_t step) {
        return std::ranges::find(moments, step, &Moment::step) != moments.end();
    };
    draw_pairs(inputs, pictures, is_wanted, [&](PairPicture picture) { drawn.push_back(std::move(picture)); });
    return drawn;
}

std::string title_of(const CompareArguments& options) {
    return options.engine.empty() ? "Comparison of two runs" : options.a + " in tumble and in Box2D";
}

std::string text_report(const CompareArguments& options, const ComparedRuns& runs, std::uint64_t frames) {
    std::string text = runs.name_a + " beside " + runs.name_b + "\n";
    for (const std::string& note : runs.notes) text += "  Box2D: " + note + "\n";
    text += to_text(runs.comparison, tolerance_of(options));
    for (const std::filesystem::path& file : {options.page, options.csv})
        if (!file.empty()) text += file.string() + "\n";
    if (frames == 0) return text;
    if (!options.video.empty()) text += options.video.string() + "\n";
    if (!options.frames.empty()) text += options.frames.string() + ": " + counted(frames, "frame") + "\n";
    return text;
}

ExitCode show_comparison(const Command& command, const CompareArguments& options) {
    const CompareInputs inputs = inputs_of(options);
    refuse_wrong_outputs(options, inputs);
    const PairPictures pictures{options.size, options.is_overlaid, options.overlay, options.renderer};
    const ComparedFrames frame_options{options.frames, options.video, options.frames_per_second, pictures};
    if (!options.video.empty()) {
        compared_video(frame_options);  // refuses a name or a size
        require_encoder();
    }
    const ComparedRuns runs = compare_runs(inputs, tolerance_of(options));
    if (!options.csv.empty()) write_file(options.csv, to_csv(runs), options.force);
    if (!options.page.empty()) {
        const std::vector<Moment> moments = moments_of(runs);
        const std::vector<PairPicture> drawn = draw_moments(inputs, moments, pictures);
        const std::string player = compared_player(inputs, runs, pictures);
        write_file(options.page, compared_page(title_of(options), runs, moments, drawn, player, tolerance_of(options)),
                   options.force);
    }
    std::uint64_t frames = 0;
    if (options.wants_frames()) {
        catch_interrupts();
        frames = write_frames(inputs, runs, frame_options);
    }
    if (is_interrupted()) return interruption_code();
    command.json ? write_output(to_json(runs.comparison)) : write_report(text_report(options, runs, frames));
    return ExitCode::ok;
}

}  // namespace

void add_compare(CLI::App& app, Command& command) {
    const auto options = std::make_shared<CompareArguments>();
    CLI::App& compare_app =
        add_subcommand(app, command, "compare", "Show two runs, or a scene in tumble and in Box2D, side by side");
    compare_app
        .add_option("A", options->a,
                    "A scene to simulate, a trajectory (.csv), or the folder of a run with trajectory.csv")
        ->required();
    compare_app.add_option("B", options->b, "What to show beside A: the same kinds; none with --engine");
    compare_app.add_option("--engine", options->engine, "Simulate the scene A also in this engine: box2d")
        ->check(CLI::IsMember({"box2d"}));
    add_change_options(compare_app, options->changes, "the scene B, or of A with --engine");
    allow_standard_output(*compare_app
                               .add_option("-o,--output", options->page,
                                           "Write an HTML page that plays both, with pictures, plots and differences")
                               ->type_name("F.html"))
        .check(page_name());
    allow_standard_output(
        *compare_app.add_option("--csv", options->csv, "Write the differences and both energies of each step")
             ->type_name("F.csv"));
    compare_app
        .add_option("--frames", options->frames,
                    "Draw frames of both into this folder, with plots of their distance and energies")
        ->type_name("DIR")
        ->check(folder_name());
    allow_standard_output(
        *compare_app.add_option("--video", options->video, "Write these frames as a video: .mp4, .webm, .gif or .apng")
             ->type_name("F"));
    compare_app.add_option("--fps", options->frames_per_second, "Frames per simulated second")
        ->type_name("N")
        ->capture_default_str()
        ->check(number_from_to(1e-3, 1e5));
    compare_app.add_flag("--overlaid", options->is_overlaid, "Draw both over each other, instead of side by side");
    compare_app
        .add_option("--tolerance", options->tolerance,
                    "Ignore differences up to this (m, rad, m/s, rad/s); default 0, of engines 0.01")
        ->type_name("D")
        ->check(number_from_to(0.0, 1e9));
    compare_app.add_option("--duration", options->duration, "Simulated time in seconds; default: that of the scenes")
        ->type_name("S")
        ->check(number_from_to(0.0, kMaxDuration));
    add_size_option(compare_app, options->size, "640x360");
    add_overlay_option(compare_app, options->overlay);
    add_renderer_option(compare_app, options->renderer);
    compare_app.add_flag("--force", options->force, "Replace existing files");
    compare_app.parse_complete_callback([&compare_app] {
        const std::initializer_list<const char*> frames{"--frames", "--video"};
        const std::initializer_list<const char*> pictures{"--frames", "--video", "--output"};
        warn_of_missing(compare_app, {"--fps"}, frames, "frames");
        warn_of_missing(compare_app, {"--overlaid", "--renderer", "--size", "--overlay", "--hide", "--theme"}, pictures,
                        "pictures");
    });
    compare_app.callback(
        [&command, options] { command.action = [&command, options] { return show_comparison(command, *options); }; });
}

}  // namespace tumble::tools
