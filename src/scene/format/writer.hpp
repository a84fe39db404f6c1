// Writes the plain data of a scene to a JSON value, by the table of fields.
#pragma once

#include "scene/json/json.hpp"
#include "tumble/scene.hpp"

namespace tumble::scene {

// Keys in the table's order. Values equal to their default are left out unless `with_defaults`.
Json write_scene(const Scene& scene, bool with_defaults = false);

}  // namespace tumble::scene
