// `tumble watch`: checks and draws a scene on each save, until it is interrupted.
#include <CLI/CLI.hpp>

#include <chrono>
#include <exception>
#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "tools/cli/console.hpp"
#include "tools/cli/error_report.hpp"
#include "tools/cli/interrupt.hpp"
#include "tools/cli/output_path.hpp"
#include "tools/cli/validators.hpp"
#include "tools/commands/commands.hpp"
#include "tools/output/json_writer.hpp"
#include "tools/output/standard_input.hpp"
#include "tools/run/run_options.hpp"
#include "tools/scene/check_text.hpp"
#include "tools/scene/file_watch.hpp"
#include "tools/scene/scene_options.hpp"
#include "tools/scene/scene_shot.hpp"
#include "tumble/file.hpp"

namespace tumble::tools {

namespace fs = std::filesystem;

namespace {

constexpr std::chrono::milliseconds kLongestWait{500};  // after which an interrupt is seen at the latest

struct WatchArguments {
    std::string file;
    LoadOptions changes;
    double time = 0.0;
    fs::path picture;
    FrameSize size;
    Overlay overlay;
    RenderBackend renderer = RenderBackend::automatic;
};

// The text of the scene and of each file that it includes directly. Files that cannot be read are left out, as those
// are that an editor is just replacing.
std::map<fs::path, std::string> texts_of(const std::string& file, bool allow_outside) {
    std::map<fs::path, std::string> texts;
    const auto add = [&](const fs::path& path) {
        try {
            texts[path] = read_file(path);
        } catch (const FileError&) {
        }
    };
    add(file);
    try {
        LoadOptions as_written;
        as_written.keep_includes = true;
        as_written.allow_outside = allow_outside;
        for (const SceneInclude& part : load_scene(file, as_written).include)
            add(fs::path(file).parent_path() / part.file);
    } catch (const std::exception&) {
        // The check reports what is wrong with the scene.
    }
    return texts;
}

fs::path picture_of(const WatchArguments& options) {
    return options.picture.empty() ? fs::path("out") / (fs::path(options.file).stem().string() + ".png")
                                   : options.picture;
}

// Draws the scene. Returns why it was not drawn, or an empty text.
std::string draw(const WatchArguments& options) {
    try {
        const Scene scene = load_named_scene(options.file, options.changes);
        draw_scene_at(scene, nearest_step(options.time, scene.world.steps_per_second),
                      {.size = options.size, .overlay = options.overlay, .renderer = options.renderer},
                      picture_of(options));
        return "";
    } catch (...) {
        return explain(std::current_exception()).message;
    }
}

void look(const Command& command, const WatchArguments& options) {
    SceneCheck check = check_scene_file(options.file, {.changes = options.changes, .renderer = options.renderer});
    if (is_interrupted()) return;
    // A scene that could not be read has its error in the check.
    const bool is_drawn = check.was_simulated;
    const std::string error = is_drawn ? draw(options) : check.error;
    if (command.json) {
        JsonWriter json(JsonWriter::Layout::compact);
        json.open_object().member("file", options.file).member("passed", check.code == ExitCode::ok);
        json.member("error", error).member("picture", error.empty() ? picture_of(options).string() : "");
        write_output(json.close_object().text() + "\n");
    } else {
        write_report(to_text(check));
        if (is_drawn)
            write_report(error.empty() ? "  picture: " + picture_of(options).string() + "\n" : "  " + error + "\n");
    }
    finish_output();
}

ExitCode watch(const Command& command, const WatchArguments& options) {
    if (is_standard_input(options.file)) throw CLI::ValidationError("SCENE", "standard input cannot be watched");
    if (!fs::exists(options.file)) throw FileError(options.file, "does not exist");
    if (options.picture == "-" || is_standard_output(options.picture))
        throw CLI::ValidationError("--output", "must be a file: the picture is replaced on each save");
    if (picture_of(options).extension() != ".png")
        throw CLI::ValidationError("--output",
                                   "expected a file name that ends in .png, got " + options.picture.string());
    catch_interrupts();
    FileWatch saves;
    std::map<fs::path, std::string> seen;
    saves.add(options.file);
    for (bool is_saved = true; !is_interrupted(); is_saved = saves.wait(kLongestWait)) {
        if (!is_saved) continue;
        std::map<fs::path, std::string> texts = texts_of(options.file, options.changes.allow_outside);
        if (!texts.contains(options.file) || texts == seen) continue;
        for (const auto& [file, text] : texts) saves.add(file);
        seen = std::move(texts);
        look(command, options);
    }
    return interruption_code();
}

}  // namespace

void add_watch(CLI::App& app, Command& command) {
    const auto options = std::make_shared<WatchArguments>();
    CLI::App& app_watch =
        add_subcommand(app, command, "watch", "Check and draw a scene on each save; Ctrl-C ends it with exit code 130");
    app_watch.add_option("SCENE", options->file, "Scene file")->required();
    add_change_options(app_watch, options->changes);
    app_watch.add_option("--at", options->time, "Simulated time of the frame in seconds")
        ->type_name("T")
        ->capture_default_str()
        ->check(number_from_to(0.0, kMaxDuration));
    app_watch.add_option("-o,--output", options->picture, "Picture to replace each time; default out/<scene file>.png")
        ->type_name("F.png")
        ->check(file_name());
    add_size_option(app_watch, options->size);
    add_overlay_option(app_watch, options->overlay);
    add_renderer_option(app_watch, options->renderer);
    app_watch.callback(
        [&command, options] { command.action = [&command, options] { return watch(command, *options); }; });
}

}  // namespace tumble::tools
