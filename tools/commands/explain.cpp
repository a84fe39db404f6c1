// `tumble explain`: the page of a warning, an error or an exit code, or the list of all codes.
#include <CLI/CLI.hpp>

#include <memory>
#include <string>
#include <vector>

#include "tools/cli/console.hpp"
#include "tools/commands/commands.hpp"
#include "tools/output/json_writer.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/suggest.hpp"

namespace tumble::tools {

namespace {

constexpr std::size_t kLine = 100;  // characters

std::string kind_name(ProblemPage::Kind kind) {
    switch (kind) {
        case ProblemPage::Kind::warning: return "warning";
        case ProblemPage::Kind::error: return "error";
        case ProblemPage::Kind::exit_code: return "exit code";
    }
    return "";
}

// Lines of at most kLine characters, each after two spaces; words stay whole.
std::string wrapped(std::string_view text) {
    std::string result, line;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(' ', begin), text.size());
        const std::string_view word = text.substr(begin, end - begin);
        if (!line.empty() && line.size() + 1 + word.size() > kLine) {
            result += "  " + line + "\n";
            line.clear();
        }
        line += (line.empty() ? "" : " ") + std::string(word);
        begin = end + 1;
    }
    return result + "  " + line + "\n";
}

std::string to_text(const ProblemPage& page) {
    return kind_name(page.kind) + " " + std::string(page.code) + ": " + std::string(page.title) + "\n\nMeaning\n" +
           wrapped(page.meaning) + "\nExample\n" + wrapped(page.example) + "\nRemedy\n" + wrapped(page.remedy);
}

void write(JsonWriter& json, const ProblemPage& page) {
    json.open_object().member("code", page.code).member("kind", kind_name(page.kind)).member("title", page.title);
    json.member("meaning", page.meaning).member("example", page.example).member("remedy", page.remedy).close_object();
}

ExitCode list_codes(const Command& command) {
    JsonWriter json;
    json.open_array();
    for (const ProblemPage& page : problems()) {
        write(json, page);
        const std::string gap(page.code.size() < 22 ? 22 - page.code.size() : 1, ' ');
        if (!command.json)
            write_output(std::string(page.code) + gap + kind_name(page.kind) + ": " + std::string(page.title) + "\n");
    }
    if (command.json) write_output(json.close_array().text() + "\n");
    return ExitCode::ok;
}

// The code as messages and shells show it: without the brackets of a message, in lower case, exit-7 for 7.
std::string normalized_code(std::string text) {
    if (text.size() > 1 && text.front() == '[' && text.back() == ']') text = text.substr(1, text.size() - 2);
    for (char& letter : text)
        if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
    const bool is_number = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
    return is_number ? "exit-" + text : text;
}

ExitCode explain_code(const Command& command, const std::string& asked) {
    if (asked.empty()) return list_codes(command);
    const std::string code = normalized_code(asked);
    const ProblemPage* const page = find_problem(code);
    if (page == nullptr) {
        std::vector<std::string_view> codes;
        for (const ProblemPage& known : problems()) codes.push_back(known.code);
        const std::string_view nearest = nearest_word(code, codes);
        throw CLI::ValidationError("CODE",
                                   "there is no code '" + asked + "'; " +
                                       (nearest.empty() ? "" : "did you mean '" + std::string(nearest) + "'? ") +
                                       "'tumble explain' lists all");
    }
    JsonWriter json;
    if (command.json) write(json, *page);
    write_output(command.json ? json.text() + "\n" : to_text(*page));
    return ExitCode::ok;
}

}  // namespace

void add_explain(CLI::App& app, Command& command) {
    const auto code = std::make_shared<std::string>();
    CLI::App& explain = add_subcommand(app, command, "explain", "Tell what a warning, an error or an exit code means");
    explain.add_option(
        "CODE", *code,
        "Code of the warning or error, such as stiff-spring, or number of the exit code; without it, list all");
    explain.callback([&command, code] { command.action = [&command, code] { return explain_code(command, *code); }; });
}

}  // namespace tumble::tools
