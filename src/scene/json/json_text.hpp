// JSON values as text: numbers in the shortest form that reads back exactly, vectors and small objects on one line.
#pragma once

#include <string>

#include "scene/json/json.hpp"

namespace tumble::scene {

// The shortest decimal number that reads back as `value`: 0.1, 500, 1e+20. Throws std::invalid_argument if not finite.
std::string number_text(double value);

// The text within its quotes and with its escapes; bytes that are not UTF-8 are replaced.
std::string quoted(const std::string& text);

// On one line: {"a": 1, "b": [0, 1]}.
std::string compact_text(const Json& value);

// Broken where a value does not fit into a line, indented by 2; the outermost object always, a key a line. Lists of
// numbers and vectors fill their lines. Ends with a line feed.
std::string pretty_text(const Json& value);

}  // namespace tumble::scene
