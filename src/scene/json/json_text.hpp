// JSON values as text: whole files, and short descriptions for messages.
#pragma once

#include <string>

#include "scene/json/json.hpp"

namespace tumble::scene {

// The shortest decimal number that reads back as `value`: 0.1, 500, 1e+20. Throws std::invalid_argument if not finite.
std::string number_text(double value);

// The text in double quotes, with JSON's escapes; bytes that are not UTF-8 are replaced.
std::string quoted(const std::string& text);

// On one line: {"a": 1, "b": [0, 1]}.
std::string compact_text(const Json& value);

// A value as error messages name it: 3.5, "text", an object, an array of 3.
std::string describe(const Json& value);

// Indented by 2. A value that fits on a line stays on it, except the outermost object, which has one key on each line.
// Lists of numbers and vectors fill their lines. Ends with a line feed.
std::string pretty_text(const Json& value);

}  // namespace tumble::scene
