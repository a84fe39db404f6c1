// From a JSON value to the plain data of a scene, by the table of fields. Strict: unknown keys, wrong types and values
// out of range are errors, all of them are reported.
#pragma once

#include "scene/json/diagnostics.hpp"
#include "scene/json/json.hpp"

namespace tumble::scene {

Scene read_scene(const Json& value, Diagnostics& diagnostics);
ShapeGeometry read_query_geometry(const Json& value, Diagnostics& diagnostics);

// How an error message names the value that it got: 3.5, "text", an object, an array of 3.
std::string describe(const Json& value);

}  // namespace tumble::scene
