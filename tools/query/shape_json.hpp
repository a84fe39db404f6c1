// Shapes and poses as JSON in distance queries. Coordinates and rotations are rounded to float, positions stay double.
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>

#include "tumble/math.hpp"
#include "tumble/shape.hpp"

namespace tumble::tools {

// A shape as in scene files, but its radius may be 0, it must be one convex piece, and a polygon is the exact hull of
// its vertices. `source` names it in messages. Throws SceneError or InputError.
Shape parse_shape(std::string_view text, const std::string& source);

// {"position": [x, y], "angle": degrees} or {"position": [x, y], "rotation": [c, s]}; each part may be left out.
// Throws InputError.
Pose parse_pose(std::string_view text, const std::string& source);

// True if the length is 1 up to rounding to two decimals. The numbers are then used as they are.
bool is_cosine_and_sine(DVec2 pair);

// The text as a JSON value. Throws InputError that names the source.
nlohmann::json parse_json(std::string_view text, const std::string& source);

}  // namespace tumble::tools
