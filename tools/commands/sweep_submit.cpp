// `tumble sweep submit`: a sweep as a job array of Slurm.
#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tools/cli/console.hpp"
#include "tools/cli/output_path.hpp"
#include "tools/cli/validators.hpp"
#include "tools/commands/commands.hpp"
#include "tools/output/json_writer.hpp"
#include "tools/output/standard_input.hpp"
#include "tools/scene/scene_options.hpp"
#include "tools/sweep/estimate.hpp"
#include "tools/sweep/plan_input.hpp"
#include "tools/sweep/slurm_script.hpp"
#include "tumble/file.hpp"

namespace tumble::tools {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostAnswer = 4096;  // bytes

struct SubmitArguments {
    fs::path plan;
    std::uint64_t runs = 0;
    SlurmOptions slurm;
    bool is_slurm = false, prints = false, allow_outside = false;
};

// Whether a text has no control characters and none of `special`.
bool is_plain(const std::string& text, const std::string& special) {
    return std::ranges::none_of(text, [&](char letter) {
        return static_cast<unsigned char>(letter) < ' ' || special.find(letter) != std::string::npos;
    });
}

// Submits a script and returns the number of the job. The file is named by its folder and has no quotes. The number
// becomes part of the next command, and is nothing but digits.
std::string submit(const fs::path& script, const std::string& options) {
    const std::string command = "sbatch --parsable " + options + " '" + script.string() + "'";
    FILE* const pipe = ::popen(command.c_str(), "r");
    std::string answer;
    std::array<char, 256> text{};
    while (pipe != nullptr && answer.size() < kMostAnswer && std::fgets(text.data(), text.size(), pipe) != nullptr)
        answer += text.data();
    if (pipe == nullptr || ::pclose(pipe) != 0)
        throw FileError(script, "sbatch did not accept it; is Slurm installed, and the cluster up?");
    const std::string job = answer.substr(0, answer.find_first_of(";\n"));
    if (job.empty() || job.find_first_not_of("0123456789") != std::string::npos)
        throw FileError(script, "sbatch --parsable answered no number of a job");
    return job;
}

ExitCode submit_sweep(const Command& command, SubmitArguments options) {
    if (!options.is_slurm) throw CLI::RequiredError("--slurm");
    if (is_standard_input(options.plan))
        throw CLI::ValidationError("PLAN", "must be a file, which each task of the cluster reads");
    std::vector<Diagnostic> warnings;
    const sweep::Plan plan = sweep::read_plan(options.plan, options.runs, options.allow_outside, &warnings);
    narrate_warnings(std::move(warnings));
    SlurmOptions& slurm = options.slurm;
    slurm.folder = fs::absolute(slurm.folder).lexically_normal();
    if (!slurm.folder.has_filename()) slurm.folder = slurm.folder.parent_path();  // of "out/"
    if (!is_plain(slurm.folder.string(), " '\"%"))
        throw CLI::ValidationError("--output",
                                   "must have no spaces, quotes, % or line feeds, for the scripts of Slurm");
    for (const std::string& setting : slurm.settings)
        if (!is_plain(setting, "")) throw CLI::ValidationError("--sbatch", "must have no line feeds");
    if (slurm.tasks == 0) slurm.tasks = choose_tasks(plan, estimate_sweep(plan, 1).seconds);
    slurm.tasks = std::min(slurm.tasks, shard_count(plan));
    const std::string array = missing_tasks(plan, slurm.folder, slurm.tasks);
    if (array.empty()) {
        write_output(command.json ? "{\"array\": \"\"}\n"
                                  : "all shards are stored; 'tumble sweep merge' makes the sweep complete\n");
        return ExitCode::ok;
    }
    const std::string script = slurm_script(plan, slurm, array);
    if (options.prints) {
        JsonWriter json;
        json.open_object().member("array", array).member("script", script).close_object();
        write_output(command.json ? json.text() + "\n" : script);
        return ExitCode::ok;
    }
    const fs::path folder = slurm.folder.string() + ".slurm";
    write_file(folder / "array.sh", script, true);
    write_file(folder / "merge.sh", merge_script(plan, slurm), true);
    const std::string job = submit(folder / "array.sh", "");
    const std::string merge = submit(folder / "merge.sh", "--dependency=afterany:" + job);
    JsonWriter json;
    json.open_object().member("job", job).member("merge_job", merge).member("array", array).close_object();
    write_output(command.json ? json.text() + "\n"
                              : "job " + job + ", tasks " + array + "; job " + merge + " completes " +
                                    slurm.folder.string() + "\n");
    return ExitCode::ok;
}

}  // namespace

void add_sweep_submit(CLI::App& app, Command& command) {
    const auto options = std::make_shared<SubmitArguments>();
    CLI::App& app_submit =
        add_subcommand(app, command, "submit", "Submit a sweep to a cluster, or what is missing of it");
    app_submit.add_option("PLAN", options->plan, "Plan file")->type_name("FILE")->required();
    app_submit.add_option("-o,--output", options->slurm.folder, "Folder of the results, which all nodes see")
        ->type_name("DIR")
        ->check(folder_name())
        ->required();
    app_submit.add_flag("--slurm", options->is_slurm,
                        "As a job array of Slurm, and a job that completes the folder after it");
    app_submit.add_option("--runs", options->runs, "Number of runs, in place of the plan's")
        ->type_name("N")
        ->check(whole_number_from_to(1, sweep::kMostRuns));
    app_submit
        .add_option("--tasks", options->slurm.tasks, "Tasks of the array; default: as many as take a minute each")
        ->type_name("N")
        ->check(whole_number_from_to(1, kMostTasks));
    app_submit.add_option("--sbatch", options->slurm.settings, "A further option of sbatch, --name=value; repeatable")
        ->type_name("TEXT")
        ->allow_extra_args(false);
    app_submit.add_option("--program", options->slurm.program, "Path of the program on the nodes")
        ->capture_default_str();
    add_outside_option(app_submit, options->allow_outside);
    app_submit.add_flag("--print", options->prints, "Print the script and submit nothing");
    app_submit.callback(
        [&command, options] { command.action = [&command, options] { return submit_sweep(command, *options); }; });
}

}  // namespace tumble::tools
