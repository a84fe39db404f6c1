// Shapes and poses as JSON in distance queries. Coordinates and rotations are rounded to float, positions stay double.
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>

#include "tumble/math.hpp"
#include "tumble/shape.hpp"

namespace tumble::tools {

// Reads a shape as in scene files, except that its radius may be 0 and that it must be one convex piece. `source` names
// it in messages. Throws SceneError or InputError.
Shape parse_shape(std::string_view text, const std::string& source);

// {"position": [x, y], "angle": degrees} or {"position": [x, y], "rotation": [c, s]}; both keys are optional.
// Throws InputError.
Pose parse_pose(std::string_view text, const std::string& source);

// Whether the pair is a cosine and a sine within rounding. Such a pair is used as it is, without normalization.
bool is_cosine_and_sine(DVec2 pair);

// Parses the text. Throws InputError with the source.
nlohmann::json parse_json(std::string_view text, const std::string& source);

}  // namespace tumble::tools
