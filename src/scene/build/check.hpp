// The checks that need more than one field: names that must exist and be unique, geometry that must not be degenerate,
// joints that must fit their type.
#pragma once

#include "scene/json/diagnostics.hpp"

namespace tumble::scene {

// How many entries the lists of a scene have.
struct SceneSizes {
    std::size_t materials = 0, bodies = 0, joints = 0, timeline = 0, expect = 0;
};

SceneSizes sizes_of(const Scene& scene);

// Parts of the scene that have errors in `diagnostics` already are left alone, and so is what lies behind `own`: it was
// checked where it came from, and here for what it has to do with the others only.
void check_scene(const Scene& scene, const SceneSizes& own, Diagnostics& diagnostics);

}  // namespace tumble::scene
