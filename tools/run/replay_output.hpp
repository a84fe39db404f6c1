// Records a run for its replay page, and evaluates the scene's claims for the marks on it.
#pragma once

#include <cstdint>
#include <vector>

#include "tools/run/run_options.hpp"
#include "tumble/file.hpp"
#include "tumble/recording.hpp"
#include "tumble/render.hpp"
#include "tumble/scene_run.hpp"

namespace tumble::tools {

// Throws CLI::ValidationError if the bodies of the initial state would have more than kMostReplayPoses poses in `steps`
// steps.
void require_replay(const SceneWorld& built, std::uint64_t steps);

class ReplayOutput {
public:
    // The world must be in its initial state: the camera is computed from it. The run must have passed
    // require_replay(). The scene must outlive the object. Throws FileError.
    ReplayOutput(const Scene& scene, const SceneWorld& built, const RunOptions& options);

    // To be called for the initial state and after each step.
    void record(const SceneWorld& built);

    // Writes the page and returns its size in bytes. `complete` is false for a run that was interrupted.
    std::uint64_t finish(const SceneWorld& built, bool complete);

private:
    std::vector<ReplayClaim> claims(const SceneWorld& built) const;

    const Scene& scene_;
    double aspect_ratio_;
    Camera camera_;  // of the frame of the present state, also where no frame is drawn
    OutputFile file_;
    ReplayRecorder recorder_;
    ExpectationWatch watch_;
};

}  // namespace tumble::tools
