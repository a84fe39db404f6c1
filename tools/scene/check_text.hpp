// The result of a checked scene as lines for a terminal or a log.
#pragma once

#include <string>

#include "tools/scene/scene_check.hpp"

namespace tumble::tools {

// The verdict and its details. Each failed claim is a line with the name of the file, for searches in logs.
std::string to_text(const SceneCheck& check);

}  // namespace tumble::tools
