// The results of `check` as JUnit XML, the format that continuous integration services read.
#pragma once

#include <string>
#include <vector>

#include "tools/scene/scene_check.hpp"

namespace tumble::tools {

// One suite per scene, one case per claim, the first with the time of the scene. A scene that could not be simulated
// has one more case, in error; a scene without claims, or one that was skipped, has that case alone.
std::string to_junit(const std::vector<SceneCheck>& checks);

}  // namespace tumble::tools
