// Whether the names of a scene are unique.
#pragma once

#include "scene/json/diagnostics.hpp"
#include "scene/model/names.hpp"
#include "scene/model/scene_sizes.hpp"

namespace tumble::scene {

// Of its bodies, its joints and the bodies that its timeline spawns; `names` are those of the scene. A spawned body may
// have the name of one that was despawned before.
void validate_names(const Scene& scene, const SceneSizes& own, const BodyNames& names, Diagnostics& diagnostics);

}  // namespace tumble::scene
