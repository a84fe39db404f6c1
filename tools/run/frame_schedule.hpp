// Which simulation step each frame shows. Frames are not interpolated: each shows the state after a step.
#pragma once

#include <cstdint>
#include <vector>

namespace tumble::tools {

// A part of the simulated time that frames show slowly.
struct SlowMotion {
    double from = 0.0, to = 0.0;  // s, of simulated time
    double speed = 1.0;           // simulated seconds in a second of frames, > 0, at most 1
};

struct FrameSchedule {
    double duration = 5.0;  // s, >= 0
    double frames_per_second = 60.0;
    double steps_per_second = 60.0;
    std::vector<SlowMotion> slow{};  // in order of time, without overlap

    // round(duration x rate)
    std::uint64_t step_count() const noexcept;

    // floor(duration x fps) + 1: the first frame shows the initial state. A part in slow motion counts as 1 / speed
    // times as long.
    std::uint64_t frame_count() const noexcept;

    // round(frame x rate / fps), the step after which the frame is drawn; with slow motion, the step nearest to the
    // simulated time that the frame shows.
    std::uint64_t step_of_frame(std::uint64_t frame) const noexcept;

    // The speed at which a frame shows the run: below 1 in slow motion.
    double speed_of_frame(std::uint64_t frame) const noexcept;

    // True if consecutive frames may show the same step.
    bool repeats_frames() const noexcept;

private:
    struct Moment {
        double time = 0.0;   // s, of simulated time
        double speed = 1.0;  // from here on
    };
    double shown_duration() const noexcept;  // s, of frames
    Moment moment_of_frame(std::uint64_t frame) const noexcept;
};

}  // namespace tumble::tools
