// The command line of tumble: parses the arguments, runs one subcommand, and converts an exception into an exit code.
#include <CLI/CLI.hpp>

#include <algorithm>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include "tools/cli/console.hpp"
#include "tools/cli/error_report.hpp"
#include "tools/commands/command_line.hpp"
#include "tools/commands/commands.hpp"
#include "tumble/instruction_set.hpp"
#include "tumble/suggest.hpp"

namespace {

using namespace tumble::tools;

// Replaces "help run" by "run --help", and "help" alone by "--help".
std::vector<std::string> without_help_command(std::vector<std::string> arguments) {
    if (arguments.empty() || arguments.front() != "help") return arguments;
    arguments.erase(arguments.begin());
    arguments.push_back("--help");
    return arguments;
}

ExitCode run_command(CommandLine& line, int argument_count, const char* const* argument_texts) {
    std::vector<std::string> arguments = without_help_command({argument_texts + 1, argument_texts + argument_count});
    std::ranges::reverse(arguments);  // CLI11 takes them in reverse order
    line.app.parse(std::move(arguments));
    if (line.version) return print_version(line.command.json);
    if (line.command.json && has_file_output())
        throw CLI::ValidationError("--json", "writes to standard output, and so does another option");
    return line.command.action ? line.command.action() : print_usage();
}

// An error for the first argument that is not known, with the nearest known word as a hint.
std::string unknown_argument_text(const CLI::App& app) {
    const std::vector<std::string> unknown = app.remaining(true);
    if (unknown.empty()) return "too many arguments";
    const std::string word = unknown.front().substr(0, unknown.front().find('='));
    // The innermost command: "sweep verify".
    std::vector<CLI::App*> chosen = app.get_subcommands();
    while (!chosen.empty() && !chosen.front()->get_subcommands().empty()) chosen = chosen.front()->get_subcommands();
    std::vector<std::string> known;
    if (word.starts_with('-')) {
        for (const CLI::Option* option : (chosen.empty() ? &app : chosen.front())->get_options())
            for (const std::string& name : option->get_lnames()) known.push_back(name);
    } else if (chosen.empty()) {
        for (const CLI::App* subcommand : app.get_subcommands({})) known.push_back(subcommand->get_name());
    }
    const std::string what = word.starts_with('-') ? "option" : chosen.empty() ? "command" : "argument";
    const std::string of = chosen.empty() ? "" : " of " + chosen.front()->get_name();
    const std::string dashes = word.substr(0, std::min(word.find_first_not_of('-'), word.size()));
    const std::string_view nearest = tumble::nearest_word(std::string_view(word).substr(dashes.size()),
                                                          std::vector<std::string_view>(known.begin(), known.end()));
    const std::string meant = (dashes.empty() ? "" : "--") + std::string(nearest);
    return "unknown " + what + " '" + word + "'" + of +
           (nearest.empty() ? "" : "\n  hint: did you mean '" + meant + "'?");
}

// The message for a text of CLI11 about a wrong number of values; the text begins with the name of the option.
std::string wrong_count_text(const std::string& text) {
    const std::string option = text.substr(0, text.find(':'));
    if (text.find(": At Most ") != std::string::npos) return option + ": is given more than once";
    return option + ": the value is missing";
}

std::string parse_error_text(const CLI::App& app, const CLI::ParseError& error) {
    std::string text = error.what();
    switch (static_cast<CLI::ExitCodes>(error.get_exit_code())) {
        case CLI::ExitCodes::ExtrasError: return unknown_argument_text(app);
        case CLI::ExitCodes::ArgumentMismatch: return wrong_count_text(text);
        default: return text;
    }
}

// CLI11 throws for --help too, with the exit code 0.
ExitCode answer_parse_error(CLI::App& app, const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {
        write_output(app.help("", CLI::AppFormatMode::Normal));
        return ExitCode::ok;
    }
    const std::vector<CLI::App*> chosen = app.get_subcommands();
    report_error(parse_error_text(app, error) +
                 (chosen.empty() ? "\n  hint: 'tumble --help' lists the commands"
                                 : "\n  hint: 'tumble " + chosen.front()->get_name() + " --help' lists the options"));
    return ExitCode::usage;
}

ExitCode answer_command_line(int argument_count, char** arguments) {
    CommandLine line;
    try {
        return run_command(line, argument_count, arguments);
    } catch (const CLI::ParseError& error) {
        return answer_parse_error(line.app, error);
    } catch (...) {
        return report_exception(std::current_exception(), line.command.json);
    }
}

}  // namespace

int main(int argument_count, char** arguments) {
    ExitCode code = ExitCode::internal_error;
    if (const std::string error = tumble::instruction_set_error(); !error.empty()) {
        report_error(error);
        return static_cast<int>(ExitCode::usage);
    }
    try {
        code = answer_command_line(argument_count, arguments);
        finish_output();
    } catch (...) {
        code = report_exception(std::current_exception(), false);
    }
    return static_cast<int>(code);
}
