// The results of `check` as JUnit XML, the format that continuous integration services read.
#pragma once

#include <string>
#include <vector>

#include "tools/scene/scene_check.hpp"

namespace tumble::tools {

// One suite per scene, one case per claim. A scene that could not be simulated has one more case, in error.
std::string to_junit(const std::vector<SceneCheck>& checks);

}  // namespace tumble::tools
