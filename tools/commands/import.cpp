// `tumble import`: converts a file of another program into a scene.
#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "reference/box2d/b2_rube.hpp"
#include "tools/cli/console.hpp"
#include "tools/cli/error_report.hpp"
#include "tools/cli/output_path.hpp"
#include "tools/cli/validators.hpp"
#include "tools/commands/commands.hpp"
#include "tools/machine/engines.hpp"
#include "tools/output/json_writer.hpp"
#include "tools/output/number_text.hpp"
#include "tools/output/standard_input.hpp"
#include "tools/scene/image_paths.hpp"
#include "tools/scene/scene_options.hpp"
#include "tumble/scene.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_import.hpp"

namespace tumble::tools {

namespace {

struct ImportArguments {
    std::filesystem::path source;
    std::filesystem::path scene;
    SvgOptions svg;
    bool force = false;
    bool check = false;
    bool allow_outside = false;
};

constexpr double kAllowedDifference = 1e-5;  // relative, and in m for anchors: exports and Box2D are float

bool agrees(const reference::ImportDifferences& found) {
    return found.same_count && std::max({found.mass.value, found.center.value, found.inertia.value,
                                         found.anchor.value}) <= kAllowedDifference;
}

bool is_svg(const std::filesystem::path& file) {
    if (is_standard_input(file)) {  // a drawing is XML, an export is JSON
        const std::size_t start = standard_input().find_first_not_of(" \t\r\n\xEF\xBB\xBF");
        return start != std::string::npos && standard_input()[start] == '<';
    }
    std::string extension = file.extension().string();
    for (char& letter : extension) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    return extension == ".svg";
}

ImportedScene read_source(const ImportArguments& options) {
    const bool is_drawing = is_svg(options.source);
    if (!is_standard_input(options.source))
        return is_drawing ? import_svg(options.source, options.svg) : import_rube(options.source);
    return is_drawing ? parse_svg(standard_input(), "<stdin>", options.svg) : parse_rube(standard_input(), "<stdin>");
}

// Images are named relative to the export; the scene names them relative to its own folder.
void place_images(const ImportArguments& options, ImportedScene& imported) {
    const auto folder_of = [](const std::filesystem::path& file) {
        const bool is_stream = is_standard_input(file) || is_standard_output(file);
        return is_stream || !file.has_parent_path() ? std::filesystem::path(".") : file.parent_path();
    };
    const std::vector<std::string> removed =
        move_images(imported.scene, folder_of(options.source), folder_of(options.scene), options.allow_outside);
    if (removed.empty()) return;
    constexpr std::size_t kNamed = 3;
    ImportNote note{
        "images outside of the folder of the scene (--allow-outside keeps them)", static_cast<int>(removed.size()), {}};
    for (std::size_t i = 0; i < std::min(kNamed, removed.size()); ++i) note.owners.push_back("'" + removed[i] + "'");
    imported.notes.push_back(note);
}

std::ptrdiff_t count_of(const ImportedScene& imported, BodyType type) {
    return std::ranges::count(imported.scene.bodies, type, &SceneBody::type);
}

// How the importer chooses the types of bodies: a drawing has no such property.
constexpr const char* kSvgRule =
    "In an SVG drawing, filled shapes become dynamic bodies and unfilled lines become static chains.\n"
    "To choose another type, set class=\"static\" (or \"kinematic\", \"dynamic\"), data-type=\"static\", or a label\n"
    "or id that begins with the word, on the shape or its group.";

void write_note(JsonWriter& json, const ImportNote& note) {
    json.open_object().member("feature", note.feature).member("count", note.count);
    json.key("owners").open_array();
    for (const std::string& owner : note.owners) json.value(owner);
    json.close_array().close_object();
}

// The name of a quantity, and its largest difference.
struct NamedDifference {
    const char* key;
    const char* of;
    const reference::ImportDifference& found;
};

std::array<NamedDifference, 4> differences_of(const reference::ImportDifferences& check) {
    return {{{"mass", "mass", check.mass},
             {"center", "centre of mass", check.center},
             {"inertia", "moment of inertia", check.inertia},
             {"anchor_m", "anchors", check.anchor}}};
}

void write_check(JsonWriter& json, const reference::ImportDifferences& check) {
    write_engines(json);
    json.key("check").open_object().member("agrees", agrees(check)).member("same_count", check.same_count);
    json.member("bodies", check.bodies).member("joints", check.joints);
    json.member("refused_inertias", check.refused_inertias);
    for (const NamedDifference& one : differences_of(check)) json.member(one.key, one.found.value);
    json.key("owners").open_object();
    for (const NamedDifference& one : differences_of(check)) json.member(one.key, one.found.owner);
    json.close_object().close_object();
}

std::string note_text(const ImportNote& note) {
    std::string text = "not imported: " + note.feature + " (" + std::to_string(note.count) + ")";
    for (const std::string& owner : note.owners) text += (&owner == note.owners.data() ? ": " : ", ") + owner;
    return text + (note.count > static_cast<int>(note.owners.size()) && !note.owners.empty() ? ", ..." : "");
}

std::string check_text(const reference::ImportDifferences& check) {
    std::string text = "compared with Box2D: " + counted(check.bodies, "dynamic body") + ", masses within ";
    append_number(text, check.mass.value);
    append_number(text += ", centres within ", check.center.value);
    append_number(text += ", inertias within ", check.inertia.value);
    append_number(text += " (relative); " + counted(check.joints, "joint") + ", anchors within ", check.anchor.value);
    text += " m\n" + engines_text();
    if (check.refused_inertias > 0)
        text += "  not compared are moments of inertia that Box2D does not accept: " +
                std::to_string(check.refused_inertias) + "\n";
    if (!check.same_count) text += "  the numbers of bodies or joints differ\n";
    for (const NamedDifference& one : differences_of(check))
        if (one.found.value > kAllowedDifference)
            text += "  the difference is too large: " + std::string(one.of) + " of '" + one.found.owner + "'\n";
    return text;
}

void write_json(const ImportArguments& options, const ImportedScene& imported,
                const std::optional<reference::ImportDifferences>& check) {
    JsonWriter json;
    json.open_object().member("scene", options.scene.string());
    json.member("bodies", imported.scene.bodies.size()).member("dynamic", count_of(imported, BodyType::dynamic_body));
    json.member("static", count_of(imported, BodyType::static_body)).member("joints", imported.scene.joints.size());
    json.key("not_carried_over").open_array();
    for (const ImportNote& note : imported.notes) write_note(json, note);
    json.close_array().key("warnings");
    write_diagnostics(json, imported.warnings);
    if (check) write_check(json, *check);
    write_output(json.close_object().text() + "\n");
}

void write_text(const ImportArguments& options, const ImportedScene& imported,
                const std::optional<reference::ImportDifferences>& check) {
    write_report(options.scene.string() + ": " + counted(imported.scene.bodies.size(), "body") + " (" +
                 std::to_string(count_of(imported, BodyType::dynamic_body)) + " dynamic, " +
                 std::to_string(count_of(imported, BodyType::static_body)) + " static), " +
                 counted(imported.scene.joints.size(), "joint") + "\n");
    for (const ImportNote& note : imported.notes) report_warning(note_text(note));
    for (const Diagnostic& warning : imported.warnings) narrate(to_string(warning) + "\n");
    if (imported.scene.bodies.empty())
        report_warning(options.source.string() + ": no bodies found; the scene is empty");
    if (is_svg(options.source)) narrate(std::string(kSvgRule) + "\n");
    if (check) write_report(check_text(*check));
}

ExitCode import_scene(const Command& command, const ImportArguments& options) {
    if (options.check && is_svg(options.source))
        throw CLI::ValidationError(
            "--check",
            "compares R.U.B.E. exports with Box2D; it has no meaning for a drawing: " + options.source.string());
    if (options.check && is_standard_input(options.source))
        throw CLI::ValidationError("--check", "reads the export a second time: it needs a file, not standard input");
    std::error_code ignored;
    if (std::filesystem::equivalent(options.source, options.scene, ignored))
        throw CLI::ValidationError("--output", "names the file that is imported: " + options.scene.string());
    refuse_to_overwrite(options.scene, options.force);
    ImportedScene imported = read_source(options);
    place_images(options, imported);
    create_folder_of(options.scene);
    save_scene(imported.scene, options.scene);
    std::optional<reference::ImportDifferences> check;
    if (options.check) check = reference::compare_with_box2d(options.source, imported.scene);
    if (command.json)
        write_json(options, imported, check);
    else
        write_text(options, imported, check);
    return check && !agrees(*check) ? ExitCode::failed : ExitCode::ok;
}

}  // namespace

void add_import(CLI::App& app, Command& command) {
    const auto options = std::make_shared<ImportArguments>();
    CLI::App& app_import =
        add_subcommand(app, command, "import", "Convert a R.U.B.E. (b2dJson) export or an SVG drawing into a scene");
    app_import.footer(kSvgRule);
    app_import
        .add_option("FILE", options->source, "R.U.B.E. export (.json, .js) or drawing (.svg); - is standard input")
        ->required();
    app_import
        .add_option(
            "--scale", options->svg.metres_per_pixel,
            "Metres for a pixel of an SVG page, which is 1/96 inch: 0.01 makes 1280 x 720 px 12.8 m x 7.2 m, and "
            "210 x 297 mm 7.94 m x 11.2 m; 0.000264583 keeps the printed size")
        ->type_name("M")
        ->capture_default_str()
        ->check(number_from_to(1e-6, 1e6));
    app_import
        .add_option("--tolerance", options->svg.tolerance, "Largest distance between an SVG curve and its chords, in m")
        ->type_name("M")
        ->capture_default_str()
        ->check(number_from_to(1e-9, 1e6));
    allow_standard_output(
        *app_import.add_option("-o,--output", options->scene, "Scene file to write; - is standard output")
             ->type_name("SCENE")
             ->required());
    app_import.add_flag(
        "--check", options->check,
        "Compare masses, inertias and anchors with Box2D, built from the same export; exit code 7 if they differ");
    add_outside_option(app_import, options->allow_outside);
    app_import.add_flag("--force", options->force, "Replace the scene file if it exists");
    app_import.callback(
        [&command, options] { command.action = [&command, options] { return import_scene(command, *options); }; });
}

}  // namespace tumble::tools
