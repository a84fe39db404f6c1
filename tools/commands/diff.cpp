// `tumble diff`: reports where two runs first differ.
#include <memory>
#include <string>

#include "tools/cli/console.hpp"
#include "tools/cli/validators.hpp"
#include "tools/commands/commands.hpp"
#include "tools/diff/diff_report.hpp"
#include "tools/diff/hash_diff.hpp"
#include "tools/output/input_error.hpp"
#include "tools/scene/scene_options.hpp"

namespace tumble::tools {

namespace {

constexpr double kMaxTolerance = 1e9;  // m: the largest coordinate of a scene

struct DiffArguments {
    std::string a, b;
    double tolerance = 0.0;
    LoadOptions changes;  // of B
};

ExitCode diff_hashes(const Command& command, const DiffArguments& options) {
    if (options.tolerance > 0.0) report_warning("--tolerance has no effect on hashes");
    const HashComparison comparison = compare_hash_files(options.a, options.b);
    write_output(command.json ? to_json(comparison) : to_text(comparison));
    return comparison.first ? ExitCode::failed : ExitCode::ok;
}

ExitCode diff_states(const Command& command, const DiffArguments& options) {
    const std::unique_ptr<StateSource> a = open_states(options.a), b = open_states(options.b, options.changes);
    const Comparison comparison = compare_states(*a, *b, options.tolerance);
    write_output(command.json ? to_json(comparison) : to_text(comparison, options.tolerance));
    return comparison.first ? ExitCode::failed : ExitCode::ok;
}

ExitCode run_diff(const Command& command, const DiffArguments& options) {
    const bool is_changed = !options.changes.overrides.empty() || options.changes.seed;
    if (is_changed && !is_scene_file(options.b))
        throw CLI::ValidationError("--set and --seed", "change the scene B, and B is not a scene: " + options.b);
    const bool has_hashes_a = is_hash_file(options.a), has_hashes_b = is_hash_file(options.b);
    if (has_hashes_a != has_hashes_b)
        throw InputError((has_hashes_a ? options.a : options.b) +
                         ": a list of hashes can only be compared with another list of hashes");
    return has_hashes_a ? diff_hashes(command, options) : diff_states(command, options);
}

}  // namespace

void add_diff(CLI::App& app, Command& command) {
    const auto options = std::make_shared<DiffArguments>();
    CLI::App& diff =
        add_subcommand(app, command, "diff", "Report where two runs first differ; exit code 7 if they differ");
    diff.add_option("A", options->a,
                    "A trajectory (.csv), a run's folder with trajectory.csv, a scene to simulate, or a list of hashes "
                    "(.csv)")
        ->required();
    diff.add_option("B", options->b, "What to compare A with: the same kinds")->required();
    add_change_options(diff, options->changes, "the scene B");
    diff.add_option("--tolerance", options->tolerance, "Ignore differences up to this (m, rad, m/s, rad/s)")
        ->type_name("D")
        ->capture_default_str()
        ->check(number_from_to(0.0, kMaxTolerance));
    diff.callback(
        [&command, options] { command.action = [&command, options] { return run_diff(command, *options); }; });
}

}  // namespace tumble::tools
