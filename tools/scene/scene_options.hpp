// The arguments of every subcommand that reads a scene, and reading it.
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

#include "tumble/scene.hpp"
#include "tumble/scene_file.hpp"

namespace tumble::tools {

struct SceneOptions {
    std::string file;
    LoadOptions changes;
};

// --set and --seed.
void add_change_options(CLI::App& subcommand, LoadOptions& changes, const std::string& scene = "the scene");

// SCENE, --set and --seed.
void add_scene_options(CLI::App& subcommand, SceneOptions& options);

// Reads a scene; without a name it has that of its file. Throws FileError or SceneError.
Scene load_named_scene(const std::string& file, const LoadOptions& changes = {},
                       std::vector<Diagnostic>* warnings = nullptr);

// The same, and says its warnings.
Scene read_scene(const SceneOptions& options);

// Of several files, those that are not called *.schema.json, which a pattern like scenes/*.json catches too; says so.
std::vector<std::string> without_schemas(const std::vector<std::string>& files);

// The name of a scene as that of a file: its letters, digits, '.', '_' and '-'.
std::string file_name_of(std::string name);

}  // namespace tumble::tools
