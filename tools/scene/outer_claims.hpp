// Decides the claims that need more than the run of a scene: a picture of it, or another scene.
#pragma once

#include <filesystem>
#include <string>

#include "tumble/scene_run.hpp"

namespace tumble::tools {

// A `picture` or a `max_time_ratio`. `folder` is that of the scene, `last_step` that at which its run ended. Throws
// FileError, InputError, SceneError, SimulationDiverged or RenderError.
void decide_outer_claim(const Scene& scene, const SceneExpectation& claim, const std::filesystem::path& folder,
                        std::uint64_t last_step, ExpectationResult& result);

}  // namespace tumble::tools
