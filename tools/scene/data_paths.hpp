// The paths of this installation: the shipped scenes, the folder of the demo, the command that starts the binary.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tumble::tools {

// The folder of the shipped scenes: that of the installation, or of the source tree for a binary in its
// build folder. Throws FileError.
std::filesystem::path find_scenes_folder();

// All shipped scenes, sorted by name.
std::vector<std::filesystem::path> find_scenes();

// The file of the shipped scene with this name; any other name is returned as a path, as is "-". Throws FileError for a
// word that is neither a shipped scene nor a file.
std::filesystem::path find_scene(const std::string& name);

// The folder that `demo` replaces: in the build folder, or ./out/demo for an installed binary.
std::filesystem::path demo_folder();

// What a user types to run this binary: "./tools/run.sh" in the source tree, "tumble" if it is installed.
std::string command_to_type();

}  // namespace tumble::tools
