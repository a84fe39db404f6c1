// The paths of a scene's images, when the scene moves to another folder.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tumble/scene.hpp"

namespace tumble::tools {

// Makes the paths of the images, which are relative to the folder `from`, relative to the folder `to`. Images whose
// path leads out of `to` are removed, unless `allow_outside`. Returns the paths of those that were removed.
std::vector<std::string> move_images(Scene& scene, const std::filesystem::path& from, const std::filesystem::path& to,
                                     bool allow_outside);

}  // namespace tumble::tools
