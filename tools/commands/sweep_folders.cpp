// `tumble sweep verify`, `status` and `merge`: commands on the folder of a sweep.
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tools/cli/console.hpp"
#include "tools/cli/interrupt.hpp"
#include "tools/cli/validators.hpp"
#include "tools/commands/commands.hpp"
#include "tools/output/json_writer.hpp"
#include "tools/sweep/merging.hpp"
#include "tools/sweep/sweep_text.hpp"
#include "tools/sweep/verification.hpp"
#include "tumble/file.hpp"

namespace tumble::tools {

namespace {

namespace fs = std::filesystem;

struct VerifyArguments {
    fs::path folder, plan;
    double part = 0.01;
    std::uint64_t seed = 1;
};

ExitCode verify(const Command& command, const VerifyArguments& options) {
    Verification verification = verify_files(options.folder);
    if (options.plan.empty()) {
        report_warning("no run is simulated again; state the plan after the folder");
    } else {
        const std::optional<sweep::SweepHeader> header = sweep::read_manifest(options.folder).header;
        catch_interrupts();
        verify_runs(sweep::read_plan(options.plan, header->runs), options.folder, options.part, options.seed,
                    verification);
    }
    write_output(command.json ? to_json(verification) : to_text(verification));
    return verification.findings.empty() ? ExitCode::ok : ExitCode::failed;
}

ExitCode status(const Command& command, const fs::path& folder) {
    const SweepStatus status = status_of(folder);
    write_output(command.json ? to_json(status) : to_text(status));
    return ExitCode::ok;
}

struct MergeArguments {
    fs::path folder;
    std::vector<fs::path> parts;
};

ExitCode merge(const Command& command, const MergeArguments& options) {
    const ShardRanges missing = merge_folders(options.folder, options.parts);
    const SweepStatus status = status_of(options.folder);
    write_output(command.json ? to_json(status) : to_text(status));
    return missing.empty() ? ExitCode::ok : ExitCode::failed;
}

}  // namespace

void add_sweep_commands(CLI::App& app, Command& command) {
    const auto verified = std::make_shared<VerifyArguments>();
    CLI::App& app_verify =
        add_subcommand(app, command, "verify", "Compare all checksums, and simulate some runs again");
    app_verify.add_option("DIR", verified->folder, "Folder of a sweep")->required();
    app_verify.add_option("PLAN", verified->plan, "Its plan, to simulate runs again")->type_name("FILE");
    app_verify.add_option("--part", verified->part, "Part of the runs to simulate again")
        ->capture_default_str()
        ->check(number_from_to(0.0, 1.0));
    app_verify.add_option("--seed", verified->seed, "From which these runs are drawn")
        ->capture_default_str()
        ->check(any_seed());
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
}

}  // namespace tumble::tools
