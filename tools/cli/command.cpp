#include "tools/cli/command.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <string>

#include "tools/cli/console.hpp"

namespace tumble::tools {

CLI::App& add_subcommand(CLI::App& app, Command& command, const std::string& name, const std::string& description) {
    CLI::App& subcommand = *app.add_subcommand(name, description);
    subcommand.add_flag("--json", command.json, "Print one JSON document on standard output instead of text");
    subcommand.add_flag_callback("-q,--quiet", be_quiet, "Print no progress and no report, only warnings and errors");
    return subcommand;
}

void warn_of_unused(const CLI::App& subcommand, std::initializer_list<const char*> options, const char* other) {
    if (subcommand.count(other) == 0) return;
    for (const char* const option : options)
        if (subcommand.count(option) > 0) report_warning(std::string(option) + " has no effect with " + other);
}

void warn_of_missing(const CLI::App& subcommand, std::initializer_list<const char*> options,
                     std::initializer_list<const char*> needed, const char* what) {
    const auto is_given = [&](const char* option) { return subcommand.count(option) > 0; };
    if (std::ranges::any_of(needed, is_given)) return;
    for (const char* const option : options)
        if (is_given(option)) report_warning(std::string(option) + " has no effect without " + what);
}

}  // namespace tumble::tools
