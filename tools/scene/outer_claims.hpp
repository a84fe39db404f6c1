// Decides the claims that need more than the run of a scene: a picture of it, or another scene.
#pragma once

#include <filesystem>
#include <string>

#include "tumble/render.hpp"
#include "tumble/scene_run.hpp"

namespace tumble::tools {

// The run of a scene that has ended.
struct EndedRun {
    const Scene& scene;
    std::filesystem::path folder;  // of the scene
    std::uint64_t last_step = 0;
    bool allow_outside = false;  // as LoadOptions::allow_outside, for the reference scene of a claim
    RenderBackend renderer = RenderBackend::automatic;
};

// A `picture` or a `max_time_ratio`. A picture that is missing is an error, or is written with `write_missing`: then
// the claim holds. Returns whether it was written. Throws FileError, InputError, SceneError, SimulationDiverged or
// RenderError.
bool decide_outer_claim(const EndedRun& run, const SceneExpectation& claim, bool write_missing,
                        ExpectationResult& result);

}  // namespace tumble::tools
