// `check --update`: writes the hashes that were found into the scene files.
#pragma once

#include "tools/scene/scene_check.hpp"

namespace tumble::tools {

// Replaces the hash of each failed `state_hash` claim of the scene, in its file and in the result. Comments and layout
// of the file stay. The scene has been simulated to its end. Throws FileError, and then leaves the result as it was.
void update_hashes(SceneCheck& check);

}  // namespace tumble::tools
