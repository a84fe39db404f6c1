// The paths that a file names must not lead out of its folder: a file from elsewhere would read, and with
// `check --update` write, files that its user does not expect.
#pragma once

#include <filesystem>
#include <string>

#include "scene/json/diagnostics.hpp"

namespace tumble::scene {

// Reports the path at `pointer` of `file` if it leads out of the folder of `file`.
void check_named_file(const std::filesystem::path& named, const std::filesystem::path& file, const std::string& pointer,
                      Diagnostics& diagnostics);

}  // namespace tumble::scene
