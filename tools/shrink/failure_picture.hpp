// The picture of a failure: the frame of the moment at which a scene fails.
#pragma once

#include <filesystem>
#include <string>

#include "tools/shrink/failure.hpp"
#include "tumble/render.hpp"

namespace tumble::tools {

// Draws the step that decided a claim with what the claim marks, the step before a divergence, or else the last state
// to which the scene can be simulated: that of its end, or of its start. `failure.claim` is an index in the scene.
// Works in a copy of this process, because the scene may crash it. Returns the error if there is no picture, else
// nothing.
std::string draw_failure(const Scene& scene, const Failure& failure, const std::filesystem::path& file,
                         RenderBackend renderer);

}  // namespace tumble::tools
