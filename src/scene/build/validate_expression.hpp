// Static errors of a condition, at their place in its text.
#pragma once

#include <string>

#include "scene/build/references.hpp"
#include "scene/json/diagnostics.hpp"

namespace tumble::scene {

// The condition is the string at the pointer.
void validate_condition(const std::string& text, const std::string& pointer, const References& references,
                        Diagnostics& diagnostics);

}  // namespace tumble::scene
