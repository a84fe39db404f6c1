// A world from a scene's plain data.
#pragma once

#include "tumble/scene.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::scene {

enum class Start { as_written, at_rest };  // at rest: all bodies awake and without velocity

// Throws as the public build_world() does.
SceneWorld build_world(const Scene& scene, Start start);

}  // namespace tumble::scene
