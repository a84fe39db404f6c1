// Makes the ResolvedScene from which a scene is validated and its world is built.
#pragma once

#include <optional>

#include "scene/build/resolved_scene.hpp"
#include "scene/json/diagnostics.hpp"
#include "scene/model/scene_sizes.hpp"

namespace tumble::scene {

// Reports errors of names, shapes, copies and joints to `diagnostics`. The result is complete if there are no
// errors; nothing if the scene has too many copies. `own` as in validate_scene().
std::optional<ResolvedScene> resolve(const Scene& scene, const SceneSizes& own, Diagnostics& diagnostics);

// The shapes of a body; those with errors are left out. `pointer` is that of the body.
std::vector<ShapeDef> resolve_shapes(const Scene& scene, const SceneBody& body, const std::string& pointer,
                                     Diagnostics& diagnostics);

}  // namespace tumble::scene
