#include "tools/run/frame_schedule.hpp"

#include <cmath>

#include "tumble/scene_run.hpp"

namespace tumble::tools {

std::uint64_t FrameSchedule::step_count() const noexcept { return nearest_step(duration, steps_per_second); }

std::uint64_t FrameSchedule::frame_count() const noexcept {
    // 0.29 s x 100 fps is 28.999999999999996 in double: a product within rounding of a whole number is that number.
    constexpr double kRounding = 1e-12;
    return static_cast<std::uint64_t>(std::floor(duration * frames_per_second * (1.0 + kRounding))) + 1;
}

std::uint64_t FrameSchedule::step_of_frame(std::uint64_t frame) const noexcept {
    return static_cast<std::uint64_t>(std::llround(static_cast<double>(frame) * steps_per_second / frames_per_second));
}

}  // namespace tumble::tools
