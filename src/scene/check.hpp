// The checks that need more than one field: names that must exist and be unique, geometry that must not be degenerate,
// joints that must fit their type.
#pragma once

#include "scene/diagnostics.hpp"

namespace tumble::scene {

// Parts of the scene that have errors in `diagnostics` already are left alone.
void check_scene(const Scene& scene, Diagnostics& diagnostics);

}  // namespace tumble::scene
