// Who fell out of the world: the first thing that goes wrong in a new scene, and easily missed without a frame to look
// at.
#pragma once

#include <string>

#include "tumble/scene_world.hpp"

namespace tumble::tools {

// "'car' and 2 more have fallen ...", of the dynamic bodies that gravity has taken below everything that could hold
// them; empty if there is none, nothing static, or no gravity.
std::string fallen_text(const SceneWorld& built);

}  // namespace tumble::tools
