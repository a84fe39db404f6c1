// `tumble fmt`: the canonical form of a scene file.
#include <nlohmann/json.hpp>

#include <limits>
#include <memory>
#include <string>

#include "command.hpp"
#include "console.hpp"
#include "json_writer.hpp"
#include "tumble/file.hpp"
#include "tumble/scene.hpp"

namespace tumble::tools {

namespace {

constexpr std::size_t kWholeFile = std::numeric_limits<std::size_t>::max() - 1;

struct FmtArguments {
    std::string file;
    bool write = false;
};

ExitCode format(const Command& command, const FmtArguments& options) {
    const Scene scene = load_scene(options.file);
    const std::string text = to_json(scene);
    const std::string before = read_file(options.file, kWholeFile);
    const bool changes = before != text;
    // Comments may stand between any two tokens, and the canonical form has no place for them.
    if (!nlohmann::json::accept(before)) report_warning(options.file + ": its comments are not kept");
    if (options.write && changes) save_scene(scene, options.file);
    if (!options.write && !command.json) {
        write_output(text);
    } else if (command.json) {
        JsonWriter json;
        json.open_object().member("file", options.file).member("canonical", !changes);
        json.member("written", options.write && changes).close_object();
        write_output(json.text() + "\n");
    }
    return ExitCode::ok;
}

}  // namespace

void add_fmt(CLI::App& app, Command& command) {
    const auto options = std::make_shared<FmtArguments>();
    CLI::App& fmt = add_subcommand(app, command, "fmt", "Print a scene in its canonical form: one order, no defaults");
    fmt.add_option("SCENE", options->file, "Scene file")->required();
    fmt.add_flag("-w,--write", options->write, "Replace the file in place of printing");
    fmt.callback([&command, options] { command.action = [&command, options] { return format(command, *options); }; });
}

}  // namespace tumble::tools
