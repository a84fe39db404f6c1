#include "tools/cli/command.hpp"

#include <CLI/CLI.hpp>

#include "tools/cli/console.hpp"

namespace tumble::tools {

CLI::App& add_subcommand(CLI::App& app, Command& command, const std::string& name, const std::string& description) {
    CLI::App& subcommand = *app.add_subcommand(name, description);
    subcommand.add_flag("--json", command.json, "Print one JSON document on standard output instead of text");
    return subcommand;
}

void warn_of_unused(const CLI::App& subcommand, std::initializer_list<const char*> options, const char* other) {
    if (subcommand.count(other) == 0) return;
    for (const char* const option : options)
        if (subcommand.count(option) > 0) report_warning(std::string(option) + " has no effect with " + other);
}

}  // namespace tumble::tools
