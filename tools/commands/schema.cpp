// `tumble schema`: prints the JSON schema of scene files or of the plans of sweeps.
#include <CLI/CLI.hpp>

#include <memory>
#include <string>

#include "sweep/plan/plan.hpp"
#include "tools/cli/console.hpp"
#include "tools/commands/commands.hpp"
#include "tumble/scene_file.hpp"

namespace tumble::tools {

namespace {

ExitCode print_schema(const std::string& kind) {
    const std::string schema = kind == "plan" ? sweep::plan_schema() : scene_schema();
    write_output(schema.ends_with('\n') ? schema : schema + "\n");
    return ExitCode::ok;
}

}  // namespace

void add_schema(CLI::App& app, Command& command) {
    const auto kind = std::make_shared<std::string>("scene");
    CLI::App& schema =
        add_subcommand(app, command, "schema", "Print the JSON schema (Draft-07) of scene files or of plans");
    schema.add_option("KIND", *kind, "The files that the schema describes: scene or plan; default scene")
        ->check(CLI::IsMember({"scene", "plan"}));
    schema.callback([&command, kind] { command.action = [kind] { return print_schema(*kind); }; });
}

}  // namespace tumble::tools
