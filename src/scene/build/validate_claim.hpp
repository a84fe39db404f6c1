// The static errors of one claim: keys that do not go together, and bodies and joints that do not exist.
#pragma once

#include <string>

#include "scene/build/references.hpp"

namespace tumble::scene {

// Does nothing if the claim has errors in `diagnostics` already.
void validate_claim(const SceneExpectation& claim, const std::string& pointer, const References& references,
                    Diagnostics& diagnostics);

}  // namespace tumble::scene
