#include "tools/scene/scene_options.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>

#include "tools/cli/console.hpp"
#include "tools/cli/validators.hpp"
#include "tools/output/standard_input.hpp"

namespace tumble::tools {

void add_change_options(CLI::App& subcommand, LoadOptions& changes, const std::string& scene) {
    subcommand
        .add_option("--set", changes.overrides,
                    "Change a value of " + scene + ", as in /bodies/ball/position=[0,3]; repeatable")
        ->type_name("/json/pointer=value")
        ->allow_extra_args(false);
    subcommand.add_option("--seed", changes.seed, "Replace the seed of " + scene)->type_name("N")->check(any_seed());
    add_outside_option(subcommand, changes.allow_outside);
}

void add_outside_option(CLI::App& subcommand, bool& allow_outside) {
    subcommand.add_flag("--allow-outside", allow_outside, "Accept paths in files that lead out of the file's folder");
}

void add_scene_options(CLI::App& subcommand, SceneOptions& options) {
    subcommand.add_option("SCENE", options.file, "Scene file; - is standard input")->required();
    add_change_options(subcommand, options.changes);
}

Scene load_named_scene(const std::string& file, const LoadOptions& changes, std::vector<Diagnostic>* warnings) {
    Scene scene = load_scene_input(file, changes, warnings);
    if (scene.name.empty())
        scene.name = is_standard_input(file) ? "stdin" : std::filesystem::path(file).stem().string();
    return scene;
}

Scene read_scene(const SceneOptions& options) {
    std::vector<Diagnostic> warnings;
    Scene scene = load_named_scene(options.file, options.changes, &warnings);
    for (const Diagnostic& warning : warnings) narrate(to_string(warning) + "\n");
    return scene;
}

std::vector<std::string> without_schemas(const std::vector<std::string>& files) {
    const auto is_schema = [](const std::string& file) { return file.ends_with(".schema.json"); };
    const bool has_scene = !std::ranges::all_of(files, is_schema);
    std::vector<std::string> scenes;
    for (const std::string& file : files) {
        if (has_scene && is_schema(file))
            narrate(file + ": skipped, a schema and not a scene\n");
        else
            scenes.push_back(file);
    }
    return scenes;
}

std::string file_name_of(std::string name) {
    for (char& character : name) {
        const bool plain = std::isalnum(static_cast<unsigned char>(character)) != 0 || character == '_' ||
                           character == '-' || character == '.';
        if (!plain) character = '_';
    }
    if (name.starts_with('.')) name.front() = '_';
    return name;
}

}  // namespace tumble::tools
