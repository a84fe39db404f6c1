#include "tools/pages/option_list.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <sstream>

namespace tumble::tools {

namespace {

// "NAME:{johnson,voronoi}" is a value NAME with two choices.
std::vector<std::string> choices_of(const std::string& type) {
    const std::size_t open = type.find(":{"), close = type.rfind('}');
    if (open == std::string::npos || close == std::string::npos) return {};
    std::vector<std::string> choices;
    std::istringstream words(type.substr(open + 2, close - open - 2));
    for (std::string word; std::getline(words, word, ',');) choices.push_back(word);
    return choices;
}

// Values are named after what they are: "DIR", "ROOT", "F.csv", "SCENE", "FILE"; the others are numbers and texts.
ValueKind kind_of(const std::string& value) {
    if (value == "DIR" || value == "ROOT") return ValueKind::folder;
    const bool is_file = value == "F" || value.starts_with("F.") || value == "SCENE" || value == "FILE";
    return is_file ? ValueKind::file : ValueKind::text;
}

ListedOption listed(const CLI::Option& option) {
    ListedOption result;
    result.name = "--" + option.get_lnames().front();
    if (!option.get_snames().empty()) result.letter = "-" + option.get_snames().front();
    result.description = option.get_description();
    if (option.get_items_expected_max() == 0) return result;
    const std::string type = option.get_type_name();
    result.value = type.substr(0, type.find(':'));
    result.initial = option.get_default_str();
    result.choices = choices_of(type);
    // A scene may be a value too: --scene, --scenes.
    result.kind = result.name == "--scene" ? ValueKind::file : kind_of(result.value);
    return result;
}

ListedArgument listed_argument(const CLI::Option& option) {
    const std::string name = option.get_name(true);
    const bool is_input = name == "A" || name == "B";  // runs for `diff`, shapes for `distance`
    return {name, option.get_description(), option.get_required(), option.get_items_expected_max() > 1,
            is_input ? ValueKind::file : kind_of(name)};
}

ListedCommand listed_command(const CLI::App& app) {
    ListedCommand result{app.get_name(), app.get_description(), {}, {}, {}};
    for (const CLI::Option* option : app.get_options()) {
        if (option->get_positional())
            result.arguments.push_back(listed_argument(*option));
        else if (!option->get_lnames().empty())
            result.options.push_back(listed(*option));
    }
    return result;
}

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
    return app.get_subcommands([](const CLI::App*) { return true; });
}

}  // namespace

std::vector<ListedCommand> list_commands(const CLI::App& app) {
    std::vector<ListedCommand> commands{listed_command(app)};
    for (const CLI::App* command : commands_of(app)) {
        commands.push_back(listed_command(*command));
        for (const CLI::App* part : commands_of(*command)) {
            commands.back().parts.push_back(listed_command(*part));
            commands.back().parts.back().name = command->get_name() + " " + part->get_name();
        }
    }
    return commands;
}

}  // namespace tumble::tools
