// The world of a resolved scene.
#pragma once

#include "scene/build/resolved_scene.hpp"
#include "scene/json/diagnostics.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::scene {

enum class Start { as_written, at_rest };  // at rest: all bodies awake and without velocity

// `resolved` is complete: validate_scene() found no errors. Throws SceneError for what the world refuses, with the
// location that `diagnostics` finds.
SceneWorld build_world(const Scene& scene, const ResolvedScene& resolved, Start start, Diagnostics& diagnostics);

}  // namespace tumble::scene
