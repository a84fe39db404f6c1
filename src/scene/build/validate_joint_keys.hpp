// Which keys a joint of each type must have, and may have.
#pragma once

#include <string>

#include "scene/json/diagnostics.hpp"
#include "tumble/scene.hpp"

namespace tumble::scene {

void validate_joint_keys(const SceneJoint& joint, const std::string& pointer, Diagnostics& diagnostics);

}  // namespace tumble::scene
