// The command line of tumble: reads the arguments, runs one subcommand, and turns what it threw into an exit code.
#include <exception>
#include <filesystem>
#include <new>
#include <string>

#include "command.hpp"
#include "console.hpp"
#include "error_report.hpp"

namespace {

using namespace tumble::tools;

ExitCode run_command(CLI::App& app, Command& command, int argument_count, const char* const* arguments) {
    bool version = false;
    app.add_flag("--version", version, "Version, compiler, instruction sets; with --json as JSON");
    app.add_flag("--json", command.json)->group("");
    add_run(app, command);
    add_demo(app, command);
    add_shot(app, command);
    add_check(app, command);
    add_diff(app, command);
    add_validate(app, command);
    add_fmt(app, command);
    add_schema(app, command);
    add_distance(app, command);
    add_import(app, command);
    add_parity(app, command);
    add_bench(app, command);
    app.require_subcommand(0, 1);
    app.parse(argument_count, arguments);
    if (version) return print_version(command.json);
    return command.action ? command.action() : print_usage();
}

// Help is an answer, not an error; CLI11 throws for both.
ExitCode answer_parse_error(CLI::App& app, const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {
        write_output(app.help("", CLI::AppFormatMode::Normal));
        return ExitCode::ok;
    }
    report_error(std::string(error.what()) + "\n  hint: tumble COMMAND --help lists the options of a command");
    return ExitCode::usage;
}

}  // namespace

int main(int argument_count, char** arguments) {
    CLI::App app("Simulates 2D physics scenes, renders their frames off-screen, proves contact distances", "tumble");
    Command command;
    ExitCode code = ExitCode::internal_error;
    try {
        code = run_command(app, command, argument_count, arguments);
    } catch (const CLI::ParseError& error) {
        code = answer_parse_error(app, error);
    } catch (...) {
        code = report_exception(std::current_exception(), command.json);
    }
    try {
        finish_output();
    } catch (...) {
        code = report_exception(std::current_exception(), false);
    }
    return static_cast<int>(code);
}
