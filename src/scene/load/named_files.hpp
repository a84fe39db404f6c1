// The paths that a scene names must not lead out of the folder of its file: a scene from elsewhere would read, and with
// `check --update` write, files that its user does not expect.
#pragma once

#include <filesystem>

#include "scene/json/diagnostics.hpp"
#include "tumble/scene.hpp"

namespace tumble::scene {

// Reports each path of the scene's own entries that leads out of the folder of `file`.
void check_named_files(const Scene& scene, const std::filesystem::path& file, Diagnostics& diagnostics);

// Reports the path at `pointer` if it leads out of the folder of `file`.
void check_named_file(const std::filesystem::path& named, const std::filesystem::path& file, const std::string& pointer,
                      Diagnostics& diagnostics);

}  // namespace tumble::scene
