// `tumble gallery`: a page and a contact sheet of many scenes, with their claims and timings.
#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "tools/cli/console.hpp"
#include "tools/cli/interrupt.hpp"
#include "tools/cli/output_path.hpp"
#include "tools/cli/validators.hpp"
#include "tools/commands/commands.hpp"
#include "tools/gallery/gallery.hpp"
#include "tools/output/json_writer.hpp"
#include "tools/scene/scene_options.hpp"
#include "tumble/file.hpp"
#include "tumble/recording.hpp"

namespace tumble::tools {

namespace {

struct GalleryArguments {
    std::vector<std::string> files;
    GalleryOptions gallery{.check = {.threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()))}};
    std::filesystem::path folder;
    int columns = 4;
    bool has_jobs = false;  // --jobs was given
    bool force = false;
};

std::string json_report(const std::vector<GalleryEntry>& entries, const std::vector<std::filesystem::path>& files) {
    JsonWriter json;
    json.open_object().key("files").open_array();
    for (const std::filesystem::path& file : files) json.value(file.string());
    json.close_array().key("scenes").open_array();
    for (const GalleryEntry& entry : entries) {
        const SceneCheck& check = entry.check;
        json.open_object().member("file", check.file).member("name", entry.title);
        json.member("passed", check.code == ExitCode::ok).member("claims", check.expectations.size());
        json.member("steps", check.steps).member("seconds", check.seconds).member("drawn", entry.picture.has_value());
        json.close_object();
    }
    json.close_array().close_object();
    return json.text() + "\n";
}

// Of different codes the highest other than `failed` counts, then `failed`, as for check.
ExitCode gallery_code(const std::vector<GalleryEntry>& entries) {
    const auto weight = [](ExitCode code) { return code == ExitCode::failed ? 1 : static_cast<int>(code) * 10; };
    ExitCode code = ExitCode::ok;
    for (const GalleryEntry& entry : entries) {
        const ExitCode own = entry.picture_error.empty() ? entry.check.code : ExitCode::rendering;
        if (weight(own) > weight(code)) code = own;
    }
    return code;
}

void require_new_loops(const std::filesystem::path& folder, bool force) {
    std::error_code ignored;
    if (!force && !std::filesystem::is_empty(folder, ignored) && !ignored)
        throw FileError(folder, "is not empty; choose another --output, or replace its loops with --force");
}

ExitCode show(const Command& command, const GalleryArguments& options) {
    const std::filesystem::path page = options.folder / "index.html", sheet = options.folder / "sheet.png";
    for (const std::filesystem::path& file : {page, sheet}) refuse_to_overwrite(file, options.force);
    GalleryOptions settings = options.gallery;
    settings.loops = options.folder / kLoopFolder;
    if (!options.has_jobs) settings.check.threads = affordable_threads(settings);
    const std::vector<std::string> scenes = without_schemas(options.files);
    if (settings.loop) {
        require_loops(settings, scenes.size());
        require_new_loops(settings.loops, options.force);
    }
    catch_interrupts();
    const std::vector<GalleryEntry> entries = make_gallery(scenes, settings);
    if (is_interrupted()) return interruption_code();
    std::vector<std::filesystem::path> files{page};
    write_file(page, gallery_page(entries), options.force);
    for (const GalleryEntry& entry : entries)
        if (!entry.loop.empty()) files.push_back(settings.loops / entry.loop);
    if (const std::optional<Image> image = contact_sheet(entries, options.columns)) {
        write_file(sheet, to_png(*image), options.force);
        files.push_back(sheet);
    }
    for (const GalleryEntry& entry : entries)
        for (const std::string* const text : {&entry.check.error, &entry.picture_error})
            if (!text->empty())
                report_warning(text->starts_with(entry.check.file) ? *text : entry.check.file + ": " + *text);
    if (command.json) {
        write_output(json_report(entries, files));
    } else {
        for (const std::filesystem::path& file : files) write_report(file.string() + "\n");
    }
    return gallery_code(entries);
}

}  // namespace

void add_gallery(CLI::App& app, Command& command) {
    const auto options = std::make_shared<GalleryArguments>();
    CLI::App& gallery =
        add_subcommand(app, command, "gallery", "Show many scenes on a page and a sheet, with claims and timings");
    gallery.add_option("SCENE", options->files, "Scene files")->required();
    add_change_options(gallery, options->gallery.check.changes);
    gallery.add_option("-o,--output", options->folder, "Folder for index.html and sheet.png")
        ->type_name("DIR")
        ->check(folder_name())
        ->required();
    gallery
        .add_option("--at", options->gallery.time,
                    "Simulated time of the pictures in seconds; default: half of each scene's duration")
        ->type_name("T")
        ->check(number_from_to(0.0, kMaxDuration));
    gallery
        .add_option("--loop", options->gallery.loop,
                    "Also write a loop of each scene, a GIF of this many seconds from --at on; needs ffmpeg")
        ->type_name("S")
        ->check(number_from_to(0.1, 60.0));
    gallery.add_option("--columns", options->columns, "Pictures in a row of the sheet")
        ->capture_default_str()
        ->check(whole_number_from_to(1, 100));
    gallery.add_option("-j,--jobs", options->gallery.check.threads, "Scenes to simulate and draw in parallel")
        ->each([options](const std::string&) { options->has_jobs = true; })
        ->capture_default_str()
        ->check(whole_number_from_to(1, 256));
    add_size_option(gallery, options->gallery.size, "480x270");
    add_overlay_option(gallery, options->gallery.overlay);
    add_renderer_option(gallery, options->gallery.check.renderer);
    gallery.add_flag("--force", options->force, "Replace the page and the sheet if they exist");
    gallery.callback([&command, options] { command.action = [&command, options] { return show(command, *options); }; });
}

}  // namespace tumble::tools
