// Completions for bash, zsh and fish: the commands, the options of each, files and folders as values, and the names of
// the shipped scenes for `demo`, which the binary lists.
#include "tools/pages/pages.hpp"

#include <algorithm>

namespace tumble::tools {

namespace {

std::string join(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
    return text;
}

std::string command_names(const std::vector<ListedCommand>& commands) {
    std::vector<std::string> names;
    for (std::size_t i = 1; i < commands.size(); ++i) names.push_back(commands[i].name);
    return join(names);
}

// Those of a command and of its parts, each name once.
std::vector<ListedOption> options_of(const ListedCommand& command) {
    std::vector<ListedOption> options = command.options;
    for (const ListedCommand& part : command.parts)
        for (const ListedOption& option : part.options)
            if (std::ranges::find(options, option.name, &ListedOption::name) == options.end())
                options.push_back(option);
    return options;
}

std::string option_names(const ListedCommand& command) {
    std::vector<std::string> names;
    for (const ListedOption& option : options_of(command)) names.push_back(option.name);
    return join(names);
}

// Each character of `special` after `mark`.
std::string marked(const std::string& text, const std::string& special, const std::string& mark) {
    std::string result;
    for (const char c : text) result += (special.find(c) == std::string::npos ? "" : mark) + c;
    return result;
}

// In single quotes, for zsh.
std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}

// In single quotes, for fish.
std::string fish_quoted(const std::string& text) { return "'" + marked(text, "\\'", "\\") + "'"; }

bool takes_files(const ListedCommand& command) {
    for (const ListedArgument& argument : command.arguments)
        if (argument.kind == ValueKind::file) return true;
    return false;
}

constexpr const char* kListScenes = " demo --list 2> /dev/null | cut -d ' ' -f 1";

// What bash offers for the value of an option.
std::string bash_values(const ListedOption& option) {
    if (!option.choices.empty()) return "COMPREPLY=($(compgen -W '" + join(option.choices) + "' -- \"$word\"))";
    switch (option.kind) {
        case ValueKind::file: return "COMPREPLY=($(compgen -f -- \"$word\")); compopt -o filenames";
        case ValueKind::folder: return "COMPREPLY=($(compgen -d -- \"$word\")); compopt -o filenames";
        default: return "COMPREPLY=()";
    }
}

std::string bash_cases(const ListedCommand& command, const std::string& name) {
    std::string text;
    for (const ListedOption& option : options_of(command)) {
        if (option.kind == ValueKind::none) continue;
        text += "        " + name + ":" + option.name;
        if (!option.letter.empty()) text += " | " + name + ":" + option.letter;
        text += ") " + bash_values(option) + "; return ;;\n";
    }
    return text;
}

std::string zsh_value(const ListedOption& option) {
    if (option.kind == ValueKind::none) return "";
    const std::string name = ":" + marked(option.value, "\\:", "\\") + ":";
    if (!option.choices.empty()) return name + "(" + join(option.choices) + ")";
    if (option.kind == ValueKind::file) return name + "_files";
    return option.kind == ValueKind::folder ? name + "_files -/" : name;
}

std::string zsh_option(const ListedOption& option) {
    const std::string rest = "[" + marked(option.description, "\\[]:", "\\") + "]" + zsh_value(option);
    std::string text = " \\\n            " + quoted("*" + option.name + rest);
    if (!option.letter.empty()) text += " \\\n            " + quoted("*" + option.letter + rest);
    return text;
}

std::string zsh_arguments(const ListedCommand& command) {
    if (command.name == "demo") return " \\\n            '1:NAME:_tumble_scenes'";
    return takes_files(command) ? " \\\n            '*:file:_files'" : "";
}

std::string fish_option(const ListedOption& option, const std::string& condition) {
    std::string text = "complete -c tumble -n " + condition + " -l " + option.name.substr(2);
    if (!option.letter.empty()) text += " -s " + option.letter.substr(1);
    if (option.kind != ValueKind::none) text += " -r";
    if (option.kind == ValueKind::file) text += " -F";
    if (option.kind == ValueKind::folder) text += " -a '(__fish_complete_directories)'";
    if (!option.choices.empty()) text += " -a '" + join(option.choices) + "'";
    return text + " -d " + fish_quoted(option.description) + "\n";
}

}  // namespace

std::string bash_completion(const std::vector<ListedCommand>& commands) {
    std::string text = R"(# Completion of tumble for bash.
_tumble() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command= options= i
    for ((i = 1; i < COMP_CWORD; ++i)); do
        [[ ${COMP_WORDS[i]} == -* ]] || { command=${COMP_WORDS[i]}; break; }
    done
    case $command:$before in
)";
    for (std::size_t i = 1; i < commands.size(); ++i) text += bash_cases(commands[i], commands[i].name);
    text += "    esac\n    case $command in\n        '') options='" + option_names(commands.front()) + " " +
            command_names(commands) + "' ;;\n";
    for (std::size_t i = 1; i < commands.size(); ++i)
        text += "        " + commands[i].name + ") options='" + option_names(commands[i]) + "' ;;\n";
    text +=
        "    esac\n    if [[ -z $command || $word == -* ]]; then\n"
        "        COMPREPLY=($(compgen -W \"$options\" -- \"$word\"))\n"
        "    elif [[ $command == demo ]]; then\n        COMPREPLY=($(compgen -W \"$(\"$1\"";
    text += kListScenes;
    return text +
           ")\" -- \"$word\"))\n    else\n        COMPREPLY=($(compgen -f -- \"$word\"))\n"
           "        compopt -o filenames\n    fi\n}\ncomplete -F _tumble tumble\n";
}

std::string zsh_completion(const std::vector<ListedCommand>& commands) {
    std::string text = "#compdef tumble\n\n_tumble_scenes() {\n    local -a scenes=(${(f)\"$(tumble";
    text += kListScenes;
    text += ")\"})\n    _describe 'scene' scenes\n}\n\n_tumble() {\n    local -a commands=(\n";
    for (std::size_t i = 1; i < commands.size(); ++i)
        text += "        " + quoted(commands[i].name + ":" + marked(commands[i].description, "\\:", "\\")) + "\n";
    text += "    )\n    if ((CURRENT == 2)); then\n        _describe 'command' commands\n        _arguments";
    for (const ListedOption& option : commands.front().options) text += zsh_option(option);
    text +=
        "\n        return\n    fi\n    local command=$words[2]\n    shift words\n    ((CURRENT--))\n    case $command "
        "in\n";
    for (std::size_t i = 1; i < commands.size(); ++i) {
        text += "        " + commands[i].name + ")\n            _arguments";
        for (const ListedOption& option : options_of(commands[i])) text += zsh_option(option);
        text += zsh_arguments(commands[i]) + "\n            ;;\n";
    }
    return text + "    esac\n}\n\n_tumble \"$@\"\n";
}

std::string fish_completion(const std::vector<ListedCommand>& commands) {
    std::string text = "# Completion of tumble for fish.\ncomplete -c tumble -f\n";
    for (const ListedOption& option : commands.front().options) text += fish_option(option, "__fish_use_subcommand");
    for (std::size_t i = 1; i < commands.size(); ++i) {
        const ListedCommand& command = commands[i];
        const std::string condition = "'__fish_seen_subcommand_from " + command.name + "'";
        text += "complete -c tumble -n __fish_use_subcommand -a " + command.name + " -d " +
                fish_quoted(command.description) + "\n";
        for (const ListedOption& option : options_of(command)) text += fish_option(option, condition);
        if (takes_files(command)) text += "complete -c tumble -n " + condition + " -F\n";
        if (command.name == "demo")
            text += "complete -c tumble -n " + condition + " -a \"(tumble" + kListScenes + ")\"\n";
    }
    return text;
}

}  // namespace tumble::tools
