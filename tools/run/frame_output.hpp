// Draws the frames of a run and passes them to the encoder threads.
#pragma once

#include <cstdint>
#include <filesystem>

#include "tools/run/frame_schedule.hpp"
#include "tools/run/run_options.hpp"
#include "tools/run/run_report.hpp"
#include "tumble/render.hpp"

namespace tumble::tools {

class FrameOutput {
public:
    // The world must be in its initial state: the camera is computed from it.
    FrameOutput(const Scene& scene, const SceneWorld& world, const RunOptions& options, const FrameSchedule& schedule);

    // Draws the frames that show the world's current step, if there are any. Must be called after each step, because
    // the camera follows the bodies.
    void draw_due(const SceneWorld& world);

    // Waits until all frames are written. Throws the first FileError.
    WrittenFiles finish();

    std::uint64_t drawn() const noexcept { return next_frame_; }
    double render_seconds() const noexcept { return render_seconds_; }
    double encode_seconds() const noexcept { return encode_seconds_; }

private:
    const Scene& scene_;
    std::filesystem::path folder_;
    FrameSchedule schedule_;
    Renderer renderer_;
    Camera camera_;
    FrameWriter writer_;
    Overlay overlay_;
    std::uint64_t next_frame_ = 0;
    double render_seconds_ = 0.0;
    double encode_seconds_ = 0.0;
};

}  // namespace tumble::tools
