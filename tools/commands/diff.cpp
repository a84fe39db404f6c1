// `tumble diff`: reports how two runs differ: their bodies, hashes, events, summaries or frames.
#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <string>
#include <system_error>

#include "tools/cli/console.hpp"
#include "tools/cli/output_path.hpp"
#include "tools/cli/validators.hpp"
#include "tools/commands/commands.hpp"
#include "tools/diff/diff_report.hpp"
#include "tools/diff/event_diff.hpp"
#include "tools/diff/frame_diff.hpp"
#include "tools/diff/hash_diff.hpp"
#include "tools/diff/input_kind.hpp"
#include "tools/diff/summary_diff.hpp"
#include "tools/scene/scene_options.hpp"
#include "tumble/render.hpp"

namespace tumble::tools {

namespace {

constexpr double kMaxTolerance = 1e9;  // m: the largest coordinate of a scene

struct DiffArguments {
    std::string a, b;
    double tolerance = 0.0;
    LoadOptions changes;  // of B; allow_outside of A too
    std::filesystem::path heat_map;
    bool force = false;
};

ExitCode equality_code(bool is_equal) { return is_equal ? ExitCode::ok : ExitCode::failed; }

ExitCode diff_hashes(const Command& command, const DiffArguments& options) {
    if (options.tolerance > 0.0) report_warning("--tolerance has no effect on hashes");
    const HashComparison comparison = compare_hash_files(options.a, options.b);
    command.json ? write_output(to_json(comparison)) : write_report(to_text(comparison));
    return equality_code(!comparison.first);
}

ExitCode diff_states(const Command& command, const DiffArguments& options) {
    LoadOptions unchanged;
    unchanged.allow_outside = options.changes.allow_outside;
    const std::unique_ptr<StateSource> a = open_states(options.a, unchanged),
                                       b = open_states(options.b, options.changes);
    const Comparison comparison = compare_states(*a, *b, options.tolerance);
    command.json ? write_output(to_json(comparison)) : write_report(to_text(comparison, options.tolerance));
    return equality_code(comparison.is_equal());
}

ExitCode diff_events(const Command& command, const DiffArguments& options) {
    const EventComparison comparison = compare_event_files(options.a, options.b, options.tolerance);
    command.json ? write_output(to_json(comparison)) : write_report(to_text(comparison));
    return equality_code(!comparison.first);
}

ExitCode diff_summaries(const Command& command, const DiffArguments& options) {
    const SummaryComparison comparison = compare_summaries(options.a, options.b, options.tolerance);
    command.json ? write_output(to_json(comparison)) : write_report(to_text(comparison));
    return equality_code(comparison.different.empty());
}

bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
    std::error_code ignored;
    return std::filesystem::equivalent(a, b, ignored);
}

// A map of an earlier comparison would look like the result of this one if no frame differs or an error ends it.
void remove_earlier_map(const DiffArguments& options) {
    const std::filesystem::path& map = options.heat_map;
    refuse_to_overwrite(map, options.force);
    if (is_standard_output(map)) return;
    for (const std::string& input : {options.a, options.b})
        if (is_same_file(map, input) || is_same_file(map, frames_in(input) / map.filename()))
            throw CLI::ValidationError("--heat-map", "names a frame that is compared: " + map.string());
    std::filesystem::remove(map);
}

ExitCode diff_frames(const Command& command, const DiffArguments& options) {
    const bool wants_map = !options.heat_map.empty();
    if (wants_map) remove_earlier_map(options);
    const FrameComparison comparison = compare_frames(options.a, options.b, options.tolerance);
    const std::filesystem::path map = wants_map && comparison.worst ? options.heat_map : "";
    if (!map.empty()) {
        create_folder_of(map);
        write_png(comparison.heat_map, map);
    }
    command.json ? write_output(to_json(comparison, map)) : write_report(to_text(comparison));
    if (!command.json && !map.empty()) write_report("  heat map: " + map.string() + "\n");
    return equality_code(comparison.is_equal());
}

ExitCode run_diff(const Command& command, const DiffArguments& options) {
    const InputKind kind = kind_of(options.a), kind_b = kind_of(options.b);
    const bool is_changed = !options.changes.overrides.empty() || options.changes.seed;
    if (is_changed && (kind_b != InputKind::states || !is_scene_file(options.b)))
        throw CLI::ValidationError("--set and --seed", "change the scene B, and B is not a scene: " + options.b);
    if (kind != kind_b)
        throw CLI::ValidationError("A and B", "only two of a kind can be compared: " + options.a + " is " +
                                                  std::string(name_of(kind)) + ", " + options.b + " is " +
                                                  std::string(name_of(kind_b)));
    if (kind != InputKind::frames && !options.heat_map.empty())
        report_warning("--heat-map has no effect: A and B are no frames; name folders of frames, such as RUN/frames");
    switch (kind) {
        case InputKind::hashes: return diff_hashes(command, options);
        case InputKind::events: return diff_events(command, options);
        case InputKind::summary: return diff_summaries(command, options);
        case InputKind::frames: return diff_frames(command, options);
        default: return diff_states(command, options);
    }
}

}  // namespace

void add_diff(CLI::App& app, Command& command) {
    const auto options = std::make_shared<DiffArguments>();
    CLI::App& diff =
        add_subcommand(app, command, "diff", "Report how two runs differ, and where first; exit code 7 if they do");
    diff.add_option("A", options->a,
                    "A trajectory (.csv), a run's folder with trajectory.csv, a scene to simulate, a list of hashes or "
                    "of events (.csv), a summary (.json), a folder of frames, or one frame (.png); - is standard input")
        ->required();
    diff.add_option("B", options->b, "What to compare A with: the same kinds")->required();
    add_change_options(diff, options->changes, "the scene B");
    diff.add_option("--tolerance", options->tolerance,
                    "Ignore differences up to this (m, rad, m/s, rad/s; of frames: levels of 255)")
        ->type_name("D")
        ->capture_default_str()
        ->check(number_from_to(0.0, kMaxTolerance));
    allow_standard_output(
        *diff.add_option("--heat-map", options->heat_map,
                         "Of frames: draw the frame with the most different pixels, each from yellow (slightly) to red")
             ->type_name("F.png"));
    diff.add_flag("--force", options->force, "Replace the heat map if it exists");
    diff.callback(
        [&command, options] { command.action = [&command, options] { return run_diff(command, *options); }; });
}

}  // namespace tumble::tools
