// What all subcommands share: the flag --json, and an action that runs after the command line is parsed.
#pragma once

#include <functional>
#include <initializer_list>
#include <string>

#include "tools/cli/exit_code.hpp"

namespace CLI {
class App;
}

namespace tumble::tools {

struct Command {
    bool json = false;                 // print one JSON document and nothing else on standard output
    std::function<ExitCode()> action;  // of the chosen subcommand; empty if there is none
};

// Adds a subcommand with its flags --json and --quiet.
CLI::App& add_subcommand(CLI::App& app, Command& command, const std::string& name, const std::string& description);

// Warns of each of these options that is given, if `other` is given too and makes it useless. To be called after the
// command line is parsed.
void warn_of_unused(const CLI::App& subcommand, std::initializer_list<const char*> options, const char* other);

// Warns of each of these options that is given, if none of those is given that make what it is about. To be called
// after the command line is parsed.
void warn_of_missing(const CLI::App& subcommand, std::initializer_list<const char*> options,
                     std::initializer_list<const char*> needed, const char* what);

}  // namespace tumble::tools
