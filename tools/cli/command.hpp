// What every subcommand has: a name on the command line, the flag --json, and an action to run once all is parsed.
#pragma once

#include <CLI/CLI.hpp>

#include <functional>
#include <initializer_list>
#include <string>

#include "tools/cli/exit_code.hpp"

namespace tumble::tools {

struct Command {
    bool json = false;                 // print one JSON document and nothing else on standard output
    std::function<ExitCode()> action;  // of the subcommand that was chosen; empty if none
};

// Adds a subcommand with its --json flag.
CLI::App& add_subcommand(CLI::App& app, Command& command, const std::string& name, const std::string& description);

// Says which of these options were given in vain, as `beside` was too. To be called once all is parsed.
void warn_of_idle(const CLI::App& subcommand, std::initializer_list<const char*> options, const char* beside);

// One for each subcommand, defined in the file of its name. `command` must outlive the parsing and the action.
void add_run(CLI::App& app, Command& command);
void add_demo(CLI::App& app, Command& command);
void add_shot(CLI::App& app, Command& command);
void add_check(CLI::App& app, Command& command);
void add_diff(CLI::App& app, Command& command);
void add_validate(CLI::App& app, Command& command);
void add_fmt(CLI::App& app, Command& command);
void add_schema(CLI::App& app, Command& command);
void add_distance(CLI::App& app, Command& command);
void add_import(CLI::App& app, Command& command);
void add_parity(CLI::App& app, Command& command);
void add_bench(CLI::App& app, Command& command);

// `tumble` without arguments, and `tumble --version`.
ExitCode print_usage();
ExitCode print_version(bool json);

}  // namespace tumble::tools
