#include "command.hpp"

namespace tumble::tools {

CLI::App& add_subcommand(CLI::App& app, Command& command, const std::string& name, const std::string& description) {
    CLI::App& subcommand = *app.add_subcommand(name, description);
    subcommand.add_flag("--json", command.json, "Print one JSON document, and nothing else, on standard output");
    return subcommand;
}

}  // namespace tumble::tools
