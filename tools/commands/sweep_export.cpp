// `tumble sweep export`: the trajectories of a sweep for programs that learn.
#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <string>

#include "tools/cli/console.hpp"
#include "tools/cli/interrupt.hpp"
#include "tools/cli/output_path.hpp"
#include "tools/commands/commands.hpp"
#include "tools/output/json_writer.hpp"
#include "tools/output/number_text.hpp"
#include "tools/sweep/minari_export.hpp"
#include "tools/sweep/minari_metadata.hpp"
#include "tools/sweep/runs/run_record.hpp"

namespace tumble::tools {

namespace {

std::string to_json(const MinariReport& report) {
    JsonWriter json;
    json.open_object().member("dataset", report.dataset.string()).member("episodes", report.episodes);
    json.member("steps", report.steps).member("left_out", report.left_out).member("bytes", report.bytes);
    return json.close_object().text() + "\n";
}

std::string to_text(const MinariReport& report) {
    std::string text =
        report.dataset.string() + ": " + counted(report.episodes, "episode") + ", " + counted(report.steps, "step");
    if (report.left_out > 0) text += "; " + counted(report.left_out, "run") + " left out";
    return text + "\n";
}

ExitCode export_sweep(const Command& command, const MinariOptions& options) try {
    catch_interrupts();
    const MinariReport report = export_minari(options);
    command.json ? write_output(to_json(report)) : write_report(to_text(report));
    return ExitCode::ok;
} catch (const Interrupted&) {
    return interruption_code();
}

std::string must_be_dataset_id(const std::string& id) {
    return is_dataset_id(id) ? "" : "must read NAME-vN or NAMESPACE/NAME-vN, such as friction-v0, got " + id;
}

}  // namespace

void add_sweep_export(CLI::App& app, Command& command) {
    const auto options = std::make_shared<MinariOptions>();
    CLI::App& app_export =
        add_subcommand(app, command, "export", "Write the trajectories as a dataset that Minari loads");
    app_export.add_option("DIR", options->folder, "Folder of a complete sweep")->required();
    app_export
        .add_option("-o,--output", options->root, "Folder of all datasets, which Minari finds by MINARI_DATASETS_PATH")
        ->type_name("ROOT")
        ->check(folder_name())
        ->required();
    app_export.add_option("--id", options->id, "Identifier of the dataset, and its folder in ROOT: friction-v0")
        ->type_name("NAME-vN")
        ->required()
        ->check(CLI::Validator(must_be_dataset_id, ""));
    app_export
        .add_option("--reward", options->reward,
                    "Column of the table, such as a measure, that is the reward of the last step; default: 0")
        ->type_name("NAME");
    app_export.add_flag("--force", options->force, "Replace an existing dataset");
    app_export.callback(
        [&command, options] { command.action = [&command, options] { return export_sweep(command, *options); }; });
}

}  // namespace tumble::tools
