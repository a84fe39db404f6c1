// `tumble fmt`: prints or writes the canonical form of a scene file.
#include <CLI/CLI.hpp>

#include <memory>
#include <string>
#include <string_view>

#include "tools/cli/console.hpp"
#include "tools/commands/commands.hpp"
#include "tools/output/json_writer.hpp"
#include "tools/output/number_text.hpp"
#include "tools/output/standard_input.hpp"
#include "tools/scene/scene_options.hpp"
#include "tumble/file.hpp"
#include "tumble/scene.hpp"
#include "tumble/scene_file.hpp"

namespace tumble::tools {

namespace {

struct FmtArguments {
    std::string file;
    bool write = false;
    bool flat = false;
    bool force = false;
    bool allow_outside = false;
};

// Counts the comments of a valid scene: // to the end of the line, and /* */.
int count_comments(std::string_view text) {
    int count = 0;
    bool in_string = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (in_string && text[i] == '\\') {
            ++i;
        } else if (text[i] == '"') {
            in_string = !in_string;
        } else if (!in_string && text[i] == '/') {
            ++count;
            const std::string_view end = text.substr(i).starts_with("//") ? "\n" : "*/";
            const std::size_t found = text.find(end, i + 2);
            if (found == std::string_view::npos) break;
            i = found + end.size() - 1;
        }
    }
    return count;
}

ExitCode format(const Command& command, const FmtArguments& options) {
    if (options.write && is_standard_input(options.file))
        throw CLI::ValidationError("--write", "replaces a file, and standard input is none");
    LoadOptions as_written;
    as_written.keep_includes = !options.flat;
    as_written.allow_outside = options.allow_outside;
    const Scene scene = load_scene_input(options.file, as_written);
    const std::string text = to_json(scene);
    const std::string before = read_input(options.file);
    const bool changes = before != text;
    const int comments = count_comments(before);
    if (options.write && changes && comments > 0 && !options.force)
        throw FileError(options.file, "has " + counted(comments, "comment") +
                                          ", which the canonical form drops; write it without them with --force, or "
                                          "move them into \"custom\"");
    if (comments > 0)
        report_warning(options.file + ": " + counted(comments, "comment") + (comments == 1 ? " is" : " are") +
                       " dropped; \"custom\" keeps notes");
    if (options.write && changes) save_scene(scene, options.file);
    if (!options.write && !command.json) {
        write_output(text);
    } else if (command.json) {
        JsonWriter json;
        json.open_object().member("file", options.file).member("canonical", !changes);
        json.member("written", options.write && changes).member("comments_lost", comments).close_object();
        write_output(json.text() + "\n");
    }
    return ExitCode::ok;
}

}  // namespace

void add_fmt(CLI::App& app, Command& command) {
    const auto options = std::make_shared<FmtArguments>();
    CLI::App& fmt =
        add_subcommand(app, command, "fmt", "Print a scene in its canonical form: keys in one order, without defaults");
    fmt.add_option("SCENE", options->file, "Scene file; - is standard input")->required();
    fmt.add_flag("-w,--write", options->write, "Replace the file instead of printing");
    fmt.add_flag("--force", options->force, "With --write: also replace a file with comments, which are lost");
    add_outside_option(fmt, options->allow_outside);
    fmt.add_flag("--flat", options->flat, "Resolve includes: print a scene that needs no other file");
    fmt.callback([&command, options] { command.action = [&command, options] { return format(command, *options); }; });
}

}  // namespace tumble::tools
