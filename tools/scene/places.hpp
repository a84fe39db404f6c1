// Where this binary finds what belongs to it: the shipped scenes, the demo's folder, the command that starts it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tumble::tools {

// The shipped scenes: beside an installed binary, else in the source tree it was built from. Throws FileError.
std::filesystem::path find_scenes_folder();

// All shipped scenes, sorted by name.
std::vector<std::filesystem::path> find_scenes();

// The file of a shipped scene, by its name without extension; any other name is taken as a file.
std::filesystem::path find_scene(const std::string& name);

// The folder that `demo` owns and replaces: in the build folder, or for an installed binary under ./out.
std::filesystem::path demo_folder();

// What a user types to run this binary: "./tools/run.sh" in the source tree, "tumble" if installed.
std::string command_to_type();

}  // namespace tumble::tools
