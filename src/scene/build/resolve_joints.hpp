// The joints of a scene: their keys, what they join, and a definition for each copy.
#pragma once

#include "scene/build/resolved_scene.hpp"
#include "scene/json/diagnostics.hpp"
#include "scene/model/scene_sizes.hpp"

namespace tumble::scene {

// Fills ResolvedScene::joints; its bodies are resolved. A joint with errors has no copies there. Joints behind `own`
// are left out as soon as there is any error, because those errors may be the reason that a joint fails.
void resolve_joints(const Scene& scene, const SceneSizes& own, ResolvedScene& resolved, Diagnostics& diagnostics);

}  // namespace tumble::scene
