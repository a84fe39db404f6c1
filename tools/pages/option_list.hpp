// The commands and options of the command line as plain data, from which the manual page and the completions of shells
// are written.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace tumble::tools {

// What a shell offers as the value of an option.
enum class ValueKind { none, text, file, folder };  // none: the option is a flag

struct ListedOption {
    std::string name;     // "--output"
    std::string letter;   // "-o", or empty
    std::string value;    // "DIR"; empty for a flag
    std::string initial;  // the default as text, or empty
    std::string description;
    std::vector<std::string> choices;  // the only values, if there are any
    ValueKind kind = ValueKind::none;
};

struct ListedArgument {
    std::string name;  // "SCENE"
    std::string description;
    bool is_required = false;
    bool is_repeated = false;
    ValueKind kind = ValueKind::text;
};

struct ListedCommand {
    std::string name;
    std::string description;
    std::vector<ListedOption> options;
    std::vector<ListedArgument> arguments;
    std::vector<ListedCommand> parts{};  // "sweep verify" of "sweep"
};

// The first element is the program itself: its options are those before a command.
std::vector<ListedCommand> list_commands(const CLI::App& app);

}  // namespace tumble::tools
