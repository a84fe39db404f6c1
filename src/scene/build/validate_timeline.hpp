// The static errors of the timeline: keys that do not go together, and bodies and joints that do not exist.
#pragma once

#include "scene/build/references.hpp"
#include "scene/model/scene_sizes.hpp"

namespace tumble::scene {

void validate_timeline(const Scene& scene, const SceneSizes& own, const References& references,
                       Diagnostics& diagnostics);

}  // namespace tumble::scene
