// From a scene to its ResolvedScene. Both validating a file and building its world start here, so that both agree on
// what the file means.
#pragma once

#include <optional>

#include "scene/build/resolved_scene.hpp"
#include "scene/json/diagnostics.hpp"
#include "scene/model/scene_sizes.hpp"

namespace tumble::scene {

// Reports names, shapes, copies and joints that are wrong to `diagnostics`. The result is complete if there are no
// errors; nothing if the scene has too many copies. `own` as in validate_scene().
std::optional<ResolvedScene> resolve(const Scene& scene, const SceneSizes& own, Diagnostics& diagnostics);

// The shapes of a body; those with errors are left out. `pointer` is that of the body.
std::vector<ShapeDef> resolve_shapes(const Scene& scene, const SceneBody& body, const std::string& pointer,
                                     Diagnostics& diagnostics);

}  // namespace tumble::scene
