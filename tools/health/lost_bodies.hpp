// Bodies that have fallen below everything that could stop them: a common error of new scenes, and not visible without
// frames.
#pragma once

#include <string>

#include "tumble/scene_world.hpp"

namespace tumble::tools {

// "'car' and 2 more have fallen ...": the dynamic bodies that have fallen far below all static and kinematic
// shapes. Empty if there is none, if the world has no static or kinematic shape, or without gravity.
std::string lost_bodies_text(const SceneWorld& built);

}  // namespace tumble::tools
