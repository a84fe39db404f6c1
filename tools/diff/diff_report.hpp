// The result of a comparison of two runs as text and as JSON.
#pragma once

#include <string>

#include "tools/diff/trajectory_diff.hpp"

namespace tumble::tools {

std::string to_text(const Comparison& comparison, double tolerance);
std::string to_json(const Comparison& comparison);

}  // namespace tumble::tools
