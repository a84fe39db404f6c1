// What is wrong with a body beyond its shapes: for the bodies of a scene and those that its timeline spawns.
#pragma once

#include <string>

#include "scene/json/diagnostics.hpp"
#include "tumble/scene.hpp"

namespace tumble::scene {

// Warns of vertices that a polygon leaves out, too.
void validate_body(const SceneBody& body, const std::string& pointer, Diagnostics& diagnostics);

}  // namespace tumble::scene
