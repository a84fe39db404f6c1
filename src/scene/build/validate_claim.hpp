// The checks of one claim that need more than one of its fields.
#pragma once

#include <string>

#include "scene/build/references.hpp"

namespace tumble::scene {

// Left alone if it has errors in `diagnostics` already.
void validate_claim(const SceneExpectation& claim, const std::string& pointer, const References& references,
                    Diagnostics& diagnostics);

}  // namespace tumble::scene
