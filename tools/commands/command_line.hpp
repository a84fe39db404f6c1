// The whole command line: all commands with their options. The binary parses it; the manual page and the completions
// of shells are written from it.
#pragma once

#include <CLI/CLI.hpp>

#include "tools/cli/command.hpp"

namespace tumble::tools {

// The options store pointers to the members, so that it cannot be copied.
struct CommandLine {
    CommandLine();
    CommandLine(const CommandLine&) = delete;
    CommandLine& operator=(const CommandLine&) = delete;

    CLI::App app;
    Command command;
    bool version = false;
};

}  // namespace tumble::tools
