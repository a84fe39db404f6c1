#include "scene_options.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <limits>

#include "console.hpp"

namespace tumble::tools {

namespace {

// Unlike a conversion by the library, not -1, which would wrap around.
std::string check_seed(const std::string& text) {
    std::uint64_t seed = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
    if (error == std::errc{} && end == text.data() + text.size()) return "";
    return "expected a whole number from 0 to " + std::to_string(std::numeric_limits<std::uint64_t>::max()) + ", got " + text;
}

}  // namespace

void add_change_options(CLI::App& subcommand, LoadOptions& changes) {
    subcommand.add_option("--set", changes.overrides, "Change a value of the scene, /bodies/ball/position=[0, 3]; may be given again")
        ->type_name("/json/pointer=value")
        ->allow_extra_args(false);
    subcommand.add_option("--seed", changes.seed, "Seed in place of the scene's")->type_name("N")->check(CLI::Validator(check_seed, ""));
}

void add_scene_options(CLI::App& subcommand, SceneOptions& options) {
    subcommand.add_option("SCENE", options.file, "Scene file")->required();
    add_change_options(subcommand, options.changes);
}

Scene read_scene(const SceneOptions& options) {
    std::vector<Diagnostic> warnings;
    Scene scene = load_scene(options.file, options.changes, &warnings);
    for (const Diagnostic& warning : warnings) narrate(to_string(warning) + "\n");
    if (scene.name.empty()) scene.name = std::filesystem::path(options.file).stem().string();
    return scene;
}

std::vector<std::string> without_schemas(const std::vector<std::string>& files) {
    const auto is_schema = [](const std::string& file) { return file.ends_with(".schema.json"); };
    const bool has_scene = !std::ranges::all_of(files, is_schema);
    std::vector<std::string> scenes;
    for (const std::string& file : files) {
        if (has_scene && is_schema(file))
            narrate(file + ": a schema, not a scene: left out\n");
        else
            scenes.push_back(file);
    }
    return scenes;
}

std::string file_name_of(const Scene& scene, const std::filesystem::path& scene_file) {
    std::string name = scene.name.empty() ? scene_file.stem().string() : scene.name;
    for (char& character : name) {
        const bool plain = std::isalnum(static_cast<unsigned char>(character)) != 0 || character == '_' ||
                           character == '-' || character == '.';
        if (!plain) character = '_';
    }
    if (name.starts_with('.')) name.front() = '_';
    return name;
}

}  // namespace tumble::tools
