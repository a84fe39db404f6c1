// "--set /json/pointer=value": changes to a scene's JSON before it is read.
#pragma once

#include "scene/json/diagnostics.hpp"
#include "scene/json/json.hpp"

namespace tumble::scene {

// Applies the overrides in order, then the seed. A key that the file leaves out is created; below a missing "world" or
// "camera" the defaults are filled in, so that one component of a default vector can be set. Records in `diagnostics`
// errors, and which values come from which override.
void apply_overrides(const LoadOptions& options, Json& scene, Diagnostics& diagnostics);

}  // namespace tumble::scene
