// Whether the names of a scene are unique.
#pragma once

#include "scene/json/diagnostics.hpp"
#include "scene/model/names.hpp"
#include "scene/model/scene_sizes.hpp"

namespace tumble::scene {

// Reports names that two bodies, two joints or two spawned bodies share. A spawned body may have the name of one that
// was despawned before. `names` are those of the scene.
void validate_names(const Scene& scene, const SceneSizes& own, const BodyNames& names, Diagnostics& diagnostics);

}  // namespace tumble::scene
