// `tumble physics`: measures impacts, friction, joints and free flight against exact answers and Box2D.
#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "reference/physics/rows.hpp"
#include "tools/cli/console.hpp"
#include "tools/cli/output_path.hpp"
#include "tools/commands/commands.hpp"
#include "tools/measure/stopwatch.hpp"
#include "tools/physics/physics_page.hpp"
#include "tools/physics/physics_report.hpp"

namespace tumble::tools {

namespace {

struct PhysicsArguments {
    std::vector<std::string> rows;
    reference::Effort effort;
    std::string report;
    bool force = false;
    bool list = false;
};

ExitCode list_rows(const Command& command) {
    JsonWriter json;
    json.open_array();
    for (const reference::PhysicsRow& row : reference::physics_rows()) {
        json.open_object().member("name", row.name).member("title", row.title).member("bar", row.bar).close_object();
        std::string line(row.name);
        line.resize(4, ' ');
        if (!command.json) write_output(line + std::string(row.title) + "\n");
    }
    json.close_array();
    if (command.json) write_output(json.text() + "\n");
    return ExitCode::ok;
}

// The rows of the given names in the order of the page, or all.
std::vector<const reference::PhysicsRow*> chosen_rows(const std::vector<std::string>& names) {
    for (const std::string& name : names)
        if (!reference::find_physics_row(name))
            throw CLI::ValidationError("--row", "there is no row '" + name + "'; tumble physics --list names them all");
    std::vector<const reference::PhysicsRow*> rows;
    for (const reference::PhysicsRow& row : reference::physics_rows())
        if (names.empty() || std::ranges::find(names, row.name) != names.end()) rows.push_back(&row);
    return rows;
}

PhysicsResult measure(const PhysicsArguments& options) {
    const Stopwatch stopwatch;
    const std::vector<const reference::PhysicsRow*> rows = chosen_rows(options.rows);
    Progress progress("rows", rows.size());
    PhysicsResult result;
    result.is_short = options.effort.is_short;
    for (const reference::PhysicsRow* row : rows) {
        progress.show(result.rows.size());
        result.rows.push_back({.row = row, .result = reference::run_row(*row, options.effort)});
    }
    result.seconds = stopwatch.seconds();
    return result;
}

ExitCode report(const Command& command, const PhysicsArguments& options) {
    if (options.list) return list_rows(command);
    if (!options.report.empty()) refuse_to_overwrite(options.report, options.force);
    const PhysicsResult result = measure(options);
    if (command.json) {
        JsonWriter json;
        write_physics_json(json, result);
        write_output(json.text() + "\n");
    } else {
        write_report(physics_table(result));
    }
    if (!options.report.empty()) {
        write_file(options.report, physics_page(result), options.force);
        narrate_progress("report written to " + options.report + "\n");
    }
    return result.passed() ? ExitCode::ok : ExitCode::failed;
}

}  // namespace

void add_physics(CLI::App& app, Command& command) {
    const auto options = std::make_shared<PhysicsArguments>();
    CLI::App& physics = add_subcommand(
        app, command, "physics", "Measure physics against exact answers and Box2D; exit code 7 if a row does not hold");
    physics.add_option("--row", options->rows, "Only this row; repeatable");
    physics.add_flag("--short", options->effort.is_short, "Fewer phases, and nothing that takes seconds");
    allow_standard_output(
        *physics.add_option("--report", options->report, "Write an HTML page with formulas, values and plots")
             ->type_name("F.html"))
        .check(page_name());
    physics.add_flag("--force", options->force, "Replace an existing report");
    physics.add_flag("--list", options->list, "List the rows");
    physics.callback(
        [&command, options] { command.action = [&command, options] { return report(command, *options); }; });
}

}  // namespace tumble::tools
