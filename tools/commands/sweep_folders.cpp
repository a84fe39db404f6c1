// `tumble sweep verify`, `status`, `merge` and `plot`: commands on the folder of a sweep.
#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "tools/cli/console.hpp"
#include "tools/cli/interrupt.hpp"
#include "tools/cli/output_path.hpp"
#include "tools/cli/validators.hpp"
#include "tools/commands/commands.hpp"
#include "tools/output/json_writer.hpp"
#include "tools/plot/sweep_plot.hpp"
#include "tools/scene/scene_options.hpp"
#include "tools/sweep/merging.hpp"
#include "tools/sweep/plan_input.hpp"
#include "tools/sweep/runs/run_record.hpp"
#include "tools/sweep/runs/scene_texts.hpp"
#include "tools/sweep/sweep_text.hpp"
#include "tools/sweep/verification.hpp"
#include "tumble/file.hpp"
#include "tumble/render.hpp"

namespace tumble::tools {

namespace {

namespace fs = std::filesystem;

struct VerifyArguments {
    fs::path folder, plan;
    double part = 0.01;
    std::optional<std::uint64_t> seed;
    bool allow_outside = false;
};

// The plan that is stated, or the copy in the folder; empty if there is none.
fs::path plan_to_verify(const VerifyArguments& options, const sweep::SweepHeader& header) {
    if (!options.plan.empty() || header.plan_file.empty()) return options.plan;
    const fs::path copy = copies_in(options.folder) / header.plan_file;
    return fs::exists(copy) ? copy : fs::path();
}

ExitCode verify(const Command& command, const VerifyArguments& options) try {
    Verification verification = verify_files(options.folder);
    const sweep::SweepHeader header = sweep::read_manifest(options.folder).header.value();
    const fs::path plan = plan_to_verify(options, header);
    if (options.plan.empty() && verification.has_damaged_copies) {
        report_warning(
            "no run is simulated again, because copies of the plan or its scenes are damaged; state the plan after the "
            "folder");
    } else if (plan.empty()) {
        report_warning(
            "no run is simulated again, because the folder has no copy of the plan; state it after the folder");
    } else {
        catch_interrupts();
        verification.seed = options.seed ? *options.seed : std::random_device()();
        verify_runs(read_plan_input(plan, header.runs, options.allow_outside), options.folder, options.part,
                    verification);
    }
    command.json ? write_output(to_json(verification)) : write_report(to_text(verification));
    return verification.findings.empty() ? ExitCode::ok : ExitCode::failed;
} catch (const Interrupted&) {
    return interruption_code();
}

ExitCode status(const Command& command, const fs::path& folder) {
    const SweepStatus status = status_of(folder);
    command.json ? write_output(to_json(status)) : write_report(to_text(status));
    return ExitCode::ok;
}

struct MergeArguments {
    fs::path folder;
    std::vector<fs::path> parts;
};

ExitCode merge(const Command& command, const MergeArguments& options) {
    const ShardRanges missing = merge_folders(options.folder, options.parts);
    const SweepStatus status = status_of(options.folder);
    command.json ? write_output(to_json(status)) : write_report(to_text(status));
    return missing.empty() ? ExitCode::ok : ExitCode::failed;
}

struct SweepPlotArguments {
    fs::path folder, picture;
    SweepPlot plot;
    bool force = false;
};

ExitCode plot_sweep(const Command& command, const SweepPlotArguments& options) {
    const bool is_png = options.picture.extension() == ".png";
    if (!is_png && options.picture.extension() != ".svg" && !is_standard_output(options.picture))
        throw CLI::ValidationError("--output",
                                   "expected a file name that ends in .svg or .png, got " + options.picture.string());
    refuse_to_overwrite(options.picture, options.force);
    const Drawing drawing = draw_sweep(sweep::table_file(options.folder), options.plot);
    write_file(options.picture, is_png ? to_png(draw_image(drawing)) : to_svg(drawing), options.force);
    JsonWriter json;
    json.open_object().member("picture", options.picture.string()).close_object();
    command.json ? write_output(json.text() + "\n") : write_report(options.picture.string() + "\n");
    return ExitCode::ok;
}

void add_sweep_plot(CLI::App& app, Command& command) {
    const auto options = std::make_shared<SweepPlotArguments>();
    CLI::App& app_plot = add_subcommand(app, command, "plot", "Draw a column of the table over one or two others");
    app_plot.add_option("DIR", options->folder, "Folder of a complete sweep")->required();
    app_plot.add_option("--x", options->plot.x, "Column of the horizontal axis")->type_name("NAME")->required();
    app_plot
        .add_option("--y", options->plot.y, "Column of the vertical axis of a heat map; without it a dot for each run")
        ->type_name("NAME");
    app_plot.add_option("--value", options->plot.value, "Column that is shown")->type_name("NAME")->required();
    allow_standard_output(*app_plot
                               .add_option("-o,--output", options->picture,
                                           "Picture to write, .svg or .png; - is an SVG on standard output")
                               ->type_name("F")
                               ->required());
    app_plot.add_flag("--force", options->force, "Replace an existing picture");
    app_plot.callback(
        [&command, options] { command.action = [&command, options] { return plot_sweep(command, *options); }; });
}

}  // namespace

void add_sweep_commands(CLI::App& app, Command& command) {
    const auto verified = std::make_shared<VerifyArguments>();
    CLI::App& app_verify =
        add_subcommand(app, command, "verify", "Compare all checksums, and simulate some runs again");
    app_verify.add_option("DIR", verified->folder, "Folder of a sweep")->required();
    app_verify.add_option("PLAN", verified->plan, "Its plan, to simulate runs again; default: the copy in the folder")
        ->type_name("FILE");
    app_verify.add_option("--part", verified->part, "Part of the runs to simulate again")
        ->capture_default_str()
        ->check(number_from_to(0.0, 1.0));
    app_verify.add_option("--seed", verified->seed, "From which these runs are drawn; default: another each time")
        ->type_name("N")
        ->check(any_seed());
    add_outside_option(app_verify, verified->allow_outside);
    app_verify.callback(
        [&command, verified] { command.action = [&command, verified] { return verify(command, *verified); }; });

    const auto folder = std::make_shared<fs::path>();
    CLI::App& app_status = add_subcommand(app, command, "status", "Print what is complete and what is missing");
    app_status.add_option("DIR", *folder, "Folder of a sweep")->required();
    app_status.callback(
        [&command, folder] { command.action = [&command, folder] { return status(command, *folder); }; });

    const auto merged = std::make_shared<MergeArguments>();
    CLI::App& app_merge = add_subcommand(
        app, command, "merge", "Join folders of one sweep, and complete it; exit code 7 if shards are missing");
    app_merge.add_option("DIR", merged->folder, "Folder to complete")->required();
    app_merge.add_option("PARTS", merged->parts, "Folders whose shards it gets");
    app_merge.callback([&command, merged] { command.action = [&command, merged] { return merge(command, *merged); }; });

    add_sweep_plot(app, command);
}

}  // namespace tumble::tools
