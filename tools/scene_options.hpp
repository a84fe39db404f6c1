// The arguments of every subcommand that reads a scene, and reading it.
#pragma once

#include <CLI/CLI.hpp>

#include <filesystem>
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
void add_change_options(CLI::App& subcommand, LoadOptions& changes);

// SCENE, --set and --seed.
void add_scene_options(CLI::App& subcommand, SceneOptions& options);

// Reads the scene with its changes, and says its warnings; without a name it has that of its file. Throws FileError or SceneError.
Scene read_scene(const SceneOptions& options);

// Of several files, those that are not called *.schema.json, which a pattern like scenes/*.json catches too; says so.
std::vector<std::string> without_schemas(const std::vector<std::string>& files);

// The scene's name as a file name: its letters, digits, '.', '_' and '-'; of the file if it has no name.
std::string file_name_of(const Scene& scene, const std::filesystem::path& scene_file);

}  // namespace tumble::tools
