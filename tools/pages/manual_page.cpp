// The manual page, in the macros of man(7).
#include "tools/pages/pages.hpp"

namespace tumble::tools {

namespace {

// A text that roff prints as it is: no escapes, no requests, hyphens that can be copied.
std::string roff(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '\\')
            result += "\\e";
        else if (c == '-')
            result += "\\-";
        else
            result += c;
    }
    if (!result.empty() && (result[0] == '.' || result[0] == '\'')) result.insert(0, "\\&");
    return result;
}

std::string entry(const ListedOption& option) {
    std::string text = ".TP\n\\fB" + roff(option.name) + "\\fR";
    if (!option.letter.empty()) text += ", \\fB" + roff(option.letter) + "\\fR";
    if (!option.value.empty()) text += " \\fI" + roff(option.value) + "\\fR";
    text += "\n" + roff(option.description);
    for (const std::string& choice : option.choices)
        text += (&choice == option.choices.data() ? ": " : ", ") + roff(choice);
    if (!option.initial.empty()) text += " (default " + roff(option.initial) + ")";
    return text + "\n";
}

std::string synopsis(const ListedCommand& command) {
    std::string text = "\\fBtumble " + roff(command.name) + "\\fR [\\fIoptions\\fR]";
    for (const ListedArgument& argument : command.arguments) {
        const std::string name = "\\fI" + roff(argument.name) + "\\fR" + (argument.is_repeated ? "..." : "");
        text += argument.is_required ? " " + name : " [" + name + "]";
    }
    return text + "\n";
}

std::string section(const ListedCommand& command) {
    std::string text =
        ".SS " + roff(command.name) + "\n" + synopsis(command) + ".PP\n" + roff(command.description) + ".\n";
    for (const ListedArgument& argument : command.arguments)
        text += ".TP\n\\fI" + roff(argument.name) + "\\fR\n" + roff(argument.description) + "\n";
    for (const ListedOption& option : command.options) text += entry(option);
    return text;
}

constexpr const char* kEnd = R"(.SH EXIT STATUS
.TP
0
success: all requested files are complete
.TP
1
internal error
.TP
2
wrong arguments
.TP
3
invalid input: a scene, a query, a drawing or a table
.TP
4
file system: a file is missing, unreadable or exists already, or the disk is full
.TP
5
rendering failed: the OpenGL library or ffmpeg
.TP
6
the simulation diverged
.TP
7
a claim does not hold, or a comparison found a difference
.TP
130, 143
interrupted (SIGINT, SIGHUP), terminated (SIGTERM)
.SH ENVIRONMENT
.TP
NO_COLOR
If it is set, errors and warnings are not coloured.
.SH FILES
.TP
\fIPREFIX\fR/share/tumble/scenes
The shipped scenes, which \fBtumble demo\fR runs, and the JSON schema of scene files.
.SH EXAMPLES
.nf
tumble demo
tumble demo pendulum \-\-print > pendulum.json
tumble run pendulum.json \-o out/pendulum
tumble check pendulum.json
.fi
)";

}  // namespace

std::string manual_page(const std::vector<ListedCommand>& commands, const std::string& version) {
    const ListedCommand& program = commands.front();
    std::string text = ".TH TUMBLE 1 \"\" \"tumble " + version +
                       "\" \"User Commands\"\n.SH NAME\ntumble \\- headless 2D physics engine\n";
    text += ".SH SYNOPSIS\n\\fBtumble\\fR \\fIcommand\\fR [\\fIoptions\\fR] [\\fIarguments\\fR]\n";
    text += ".SH DESCRIPTION\n" + roff(program.description) + ".\n.SH OPTIONS\n";
    for (const ListedOption& option : program.options) text += entry(option);
    text += ".SH COMMANDS\n";
    for (std::size_t i = 1; i < commands.size(); ++i) {
        text += section(commands[i]);
        for (const ListedCommand& part : commands[i].parts) text += section(part);
    }
    return text + kEnd;
}

}  // namespace tumble::tools
