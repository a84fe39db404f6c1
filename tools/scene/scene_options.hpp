// The options of all subcommands that read a scene, and functions that read it.
#pragma once

#include <string>
#include <vector>

#include "tumble/scene.hpp"
#include "tumble/scene_file.hpp"

namespace CLI {
class App;
}

namespace tumble::tools {

struct SceneOptions {
    std::string file;
    LoadOptions changes;
};

// Adds --set, --seed and --allow-outside. `scene` names the scene in their help.
void add_change_options(CLI::App& subcommand, LoadOptions& changes, const std::string& scene = "the scene");

void add_outside_option(CLI::App& subcommand, bool& allow_outside);

// Adds SCENE, --set, --seed and --allow-outside.
void add_scene_options(CLI::App& subcommand, SceneOptions& options);

// Reads a scene. A scene without a name gets the name of its file. Throws FileError or SceneError.
Scene load_named_scene(const std::string& file, const LoadOptions& changes = {},
                       std::vector<Diagnostic>* warnings = nullptr);

// The same, and writes its warnings to standard error.
Scene read_scene(const SceneOptions& options);

// Drops files named *.schema.json, which a pattern like scenes/*.json matches too, with a note on standard error. If
// there are no other files, they are kept.
std::vector<std::string> without_schemas(const std::vector<std::string>& files);

// The name of a scene as the name of a file: every character but letters, digits, '.', '_' and '-' becomes '_'.
std::string file_name_of(std::string name);

}  // namespace tumble::tools
