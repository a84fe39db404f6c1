// The static errors of one body, of a scene or spawned by its timeline. Errors of its shapes are found by resolve().
#pragma once

#include <string>

#include "scene/json/diagnostics.hpp"
#include "tumble/scene.hpp"

namespace tumble::scene {

// Also warns of vertices of a polygon that its convex hull ignores.
void validate_body(const SceneBody& body, const std::string& pointer, Diagnostics& diagnostics);

}  // namespace tumble::scene
