// `check --update`: writes the hashes that were found into the scene files.
#pragma once

#include "tools/scene/scene_check.hpp"

namespace tumble::tools {

// Replaces the hash of each failed `state_hash` claim of the scene, in its file and in the result. Comments and layout
// of the file stay. A scene that was not simulated to its end is left as it is. Throws FileError.
void update_hashes(SceneCheck& check);

}  // namespace tumble::tools
