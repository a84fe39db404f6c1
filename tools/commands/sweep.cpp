// `tumble sweep`: simulates the runs of a plan into a folder.
#include <CLI/CLI.hpp>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "tools/cli/console.hpp"
#include "tools/cli/interrupt.hpp"
#include "tools/cli/output_path.hpp"
#include "tools/cli/validators.hpp"
#include "tools/commands/commands.hpp"
#include "tools/output/json_writer.hpp"
#include "tools/scene/scene_options.hpp"
#include "tools/sweep/estimate.hpp"
#include "tools/sweep/plan_input.hpp"
#include "tools/sweep/runs/run_record.hpp"
#include "tools/sweep/sweep_text.hpp"
#include "tools/sweep/sweep_work.hpp"

namespace tumble::tools {

namespace {

struct SweepArguments {
    std::filesystem::path plan;
    std::uint64_t runs = 0;
    std::string part;
    bool dry_run = false, allow_outside = false;
    SweepOptions work{.jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()))};
};

// "3/16": the numbers before and after the slash.
void read_part(const std::string& text, SweepOptions& options) {
    if (text.empty()) return;
    const char* const end = text.data() + text.size();
    const auto [slash, error] = std::from_chars(text.data(), end, options.part);
    if (error == std::errc() && slash != end && *slash == '/') {
        const auto [stop, wrong] = std::from_chars(slash + 1, end, options.parts);
        if (wrong == std::errc() && stop == end && options.part < options.parts) return;
    }
    throw CLI::ValidationError("--shard", "must read i/n with i from 0 to n - 1, got " + text);
}

ExitCode print_estimate(const Command& command, const sweep::Plan& plan, int jobs) try {
    const SweepEstimate estimate = estimate_sweep(plan, jobs);
    command.json ? write_output(to_json(estimate)) : write_report(to_text(plan, estimate));
    return ExitCode::ok;
} catch (const Interrupted&) {
    return interruption_code();
}

ExitCode sweep(const Command& command, SweepArguments options) {
    if (options.plan.empty()) throw CLI::RequiredError("PLAN");
    read_part(options.part, options.work);
    if (!options.dry_run && options.work.folder.empty()) throw CLI::RequiredError("--output");
    catch_interrupts();
    std::vector<Diagnostic> warnings;
    const sweep::Plan plan = read_plan_input(options.plan, options.runs, options.allow_outside, &warnings);
    narrate_warnings(std::move(warnings));
    if (options.dry_run) return print_estimate(command, plan, options.work.jobs);
    const SweepReport report = run_sweep(plan, options.work);
    command.json ? write_output(to_json(report)) : write_report(to_text(plan, report));
    if (report.interrupted) return interruption_code();
    return report.missing_of_part == 0 ? ExitCode::ok : ExitCode::failed;
}

}  // namespace

void add_sweep(CLI::App& app, Command& command) {
    const auto options = std::make_shared<SweepArguments>();
    CLI::App& app_sweep =
        add_subcommand(app, command, "sweep", "Simulate the runs of a plan: many seeds and parameters");
    app_sweep.add_option("PLAN", options->plan, "Plan file; - is standard input")->type_name("FILE");
    app_sweep.add_option("-o,--output", options->work.folder, "Folder of the results; a sweep in it is continued")
        ->type_name("DIR")
        ->check(folder_name());
    app_sweep.add_option("--runs", options->runs, "Number of runs, in place of the plan's")
        ->type_name("N")
        ->check(whole_number_from_to(1, sweep::kMostRuns));
    app_sweep.add_option("-j,--jobs", options->work.jobs, "Shards to simulate in parallel")
        ->capture_default_str()
        ->check(whole_number_from_to(1, 256));
    app_sweep.add_option("--shard", options->part, "Only every n-th shard, from the i-th (from 0)")->type_name("i/n");
    app_sweep
        .add_option("--lease", options->work.lease,
                    "Seconds after which the shard of a process that gives no sign is taken over")
        ->type_name("S")
        ->capture_default_str()
        ->check(number_from_to(0.1, 1e6));
    app_sweep.add_flag("--check", options->work.check,
                       "First read all stored files, and make those again whose checksums are wrong");
    app_sweep.add_flag("--dry-run", options->dry_run,
                       "Simulate 20 runs, write nothing, and print how long and how large the sweep is");
    add_outside_option(app_sweep, options->allow_outside);
    add_sweep_commands(app_sweep, command);
    add_sweep_export(app_sweep, command);
    add_sweep_submit(app_sweep, command);
    app_sweep.callback([&app_sweep, &command, options] {
        if (app_sweep.get_subcommands().empty())
            command.action = [&command, options] { return sweep(command, *options); };
    });
}

}  // namespace tumble::tools
