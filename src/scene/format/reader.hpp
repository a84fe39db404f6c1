// Reads the plain data of a scene from a JSON value, by the table of fields. Unknown keys, wrong types and values out
// of range are errors, and all of them are reported.
#pragma once

#include "scene/format/draw.hpp"
#include "scene/json/diagnostics.hpp"
#include "scene/json/json.hpp"

namespace tumble::scene {

// Numbers that are declared as random are drawn, with the seed of the context: see draw.hpp.
Scene read_scene(const Json& value, Diagnostics& diagnostics, const DrawContext& context = {});

// The seed that a scene file declares.
std::uint64_t seed_of(const Json& scene);

ShapeGeometry read_query_geometry(const Json& value, Diagnostics& diagnostics);

}  // namespace tumble::scene
