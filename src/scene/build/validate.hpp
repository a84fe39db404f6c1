// The static errors of a scene that need more than one field: what can be found without a world.
#pragma once

#include <optional>

#include "scene/build/resolved_scene.hpp"
#include "scene/json/diagnostics.hpp"
#include "scene/model/scene_sizes.hpp"

namespace tumble::scene {

// Reports what is wrong to `diagnostics`, and returns the resolved scene: complete if there are no errors, nothing if
// the scene has too many copies.
//
// A part that has errors already (from the reader) is skipped. Entries behind `own` come from included files, which
// were validated by themselves: they are only validated together with the other entries.
std::optional<ResolvedScene> validate_scene(const Scene& scene, const SceneSizes& own, Diagnostics& diagnostics);

}  // namespace tumble::scene
