// Whether the events of a timeline have the keys that go together, and act on what is there.
#pragma once

#include "scene/build/references.hpp"
#include "scene/model/scene_sizes.hpp"

namespace tumble::scene {

void validate_timeline(const Scene& scene, const SceneSizes& own, const References& references,
                       Diagnostics& diagnostics);

}  // namespace tumble::scene
