// The joints of a scene: their keys, the bodies or joints that they connect, and a definition for each copy.
#pragma once

#include "scene/build/resolved_scene.hpp"
#include "scene/json/diagnostics.hpp"
#include "scene/model/scene_sizes.hpp"

namespace tumble::scene {

// Fills ResolvedScene::joints, after its bodies were resolved. A joint with errors gets no copies. The joints after the
// first `own` were valid in their file; after any other error they are skipped, as they might only repeat its effects.
void resolve_joints(const Scene& scene, const SceneSizes& own, ResolvedScene& resolved, Diagnostics& diagnostics);

}  // namespace tumble::scene
