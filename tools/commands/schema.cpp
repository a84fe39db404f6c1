// `tumble schema`: prints the JSON schema of the scene format.
#include <string>

#include "tools/cli/console.hpp"
#include "tools/commands/commands.hpp"
#include "tumble/scene_file.hpp"

namespace tumble::tools {

namespace {

ExitCode print_schema() {
    const std::string schema = scene_schema();
    write_output(schema.ends_with('\n') ? schema : schema + "\n");
    return ExitCode::ok;
}

}  // namespace

void add_schema(CLI::App& app, Command& command) {
    CLI::App& schema = add_subcommand(app, command, "schema", "Print the JSON schema (Draft-07) of scene files");
    schema.callback([&command] { command.action = print_schema; });
}

}  // namespace tumble::tools
