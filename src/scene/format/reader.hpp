// Reads the plain data of a scene from a JSON value, by the table of fields. Unknown keys, wrong types and values out
// of range are errors, and all of them are reported.
#pragma once

#include "scene/json/diagnostics.hpp"
#include "scene/json/json.hpp"

namespace tumble::scene {

Scene read_scene(const Json& value, Diagnostics& diagnostics);
ShapeGeometry read_query_geometry(const Json& value, Diagnostics& diagnostics);

}  // namespace tumble::scene
