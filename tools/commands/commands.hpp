// The subcommands, as main() adds them to the command line.
#pragma once

#include "tools/cli/command.hpp"

namespace tumble::tools {

// One function for each subcommand, defined in the file of its name. `command` must outlive the parsing and the action.
void add_init(CLI::App& app, Command& command);
void add_run(CLI::App& app, Command& command);
void add_demo(CLI::App& app, Command& command);
void add_shot(CLI::App& app, Command& command);
void add_check(CLI::App& app, Command& command);
void add_shrink(CLI::App& app, Command& command);
void add_watch(CLI::App& app, Command& command);
void add_plot(CLI::App& app, Command& command);
void add_gallery(CLI::App& app, Command& command);
void add_compare(CLI::App& app, Command& command);
void add_diff(CLI::App& app, Command& command);
void add_validate(CLI::App& app, Command& command);
void add_explain(CLI::App& app, Command& command);
void add_fmt(CLI::App& app, Command& command);
void add_schema(CLI::App& app, Command& command);
void add_distance(CLI::App& app, Command& command);
void add_import(CLI::App& app, Command& command);
void add_parity(CLI::App& app, Command& command);
void add_bench(CLI::App& app, Command& command);
void add_physics(CLI::App& app, Command& command);
void add_doctor(CLI::App& app, Command& command);
void add_sweep(CLI::App& app, Command& command);

// The commands of `sweep` on folders: verify, status, merge, plot.
void add_sweep_commands(CLI::App& app, Command& command);

// `sweep export`.
void add_sweep_export(CLI::App& app, Command& command);

// `sweep submit`.
void add_sweep_submit(CLI::App& app, Command& command);

// `tumble` without arguments.
ExitCode print_usage();

// `tumble --version`.
ExitCode print_version(bool json);

}  // namespace tumble::tools
