// Checks the camera of a scene: the bodies that it names, and the times of key frames and notes.
#pragma once

#include "scene/build/references.hpp"

namespace tumble::scene {

void validate_camera(const SceneCamera& camera, const References& references, Diagnostics& diagnostics);

}  // namespace tumble::scene
