// Which simulation step each frame shows. Frames are not interpolated: each shows the state after a step.
#pragma once

#include <cstdint>

namespace tumble::tools {

struct FrameSchedule {
    double duration = 5.0;  // s, >= 0
    double frames_per_second = 60.0;
    double steps_per_second = 60.0;

    // round(duration x rate)
    std::uint64_t step_count() const noexcept;

    // floor(duration x fps) + 1: the first frame shows the initial state.
    std::uint64_t frame_count() const noexcept;

    // round(frame x rate / fps), the step after which the frame is drawn.
    std::uint64_t step_of_frame(std::uint64_t frame) const noexcept;

    // True if consecutive frames may show the same step.
    bool repeats_frames() const noexcept { return frames_per_second > steps_per_second; }
};

}  // namespace tumble::tools
