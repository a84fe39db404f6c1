// The static errors of a scene that concern more than one field. No world is built.
#pragma once

#include <optional>

#include "scene/build/resolved_scene.hpp"
#include "scene/json/diagnostics.hpp"
#include "scene/model/scene_sizes.hpp"

namespace tumble::scene {

// Reports errors to `diagnostics`. Returns the resolved scene: complete if there are no errors, nothing if the scene
// has too many copies.
//
// A part that has errors already, from the reader, is skipped. The entries after the first `own` come from included
// files, which were validated by themselves: only errors that they cause together with other entries are reported.
std::optional<ResolvedScene> validate_scene(const Scene& scene, const SceneSizes& own, Diagnostics& diagnostics);

}  // namespace tumble::scene
