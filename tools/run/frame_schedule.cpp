#include "tools/run/frame_schedule.hpp"

#include <algorithm>
#include <cmath>

#include "tumble/scene_run.hpp"

namespace tumble::tools {

namespace {

// 0.29 s x 100 fps is 28.999999999999996 in double: a product within rounding of a whole number is that number.
constexpr double kRounding = 1e-12;

}  // namespace

std::uint64_t FrameSchedule::step_count() const noexcept { return nearest_step(duration, steps_per_second); }

std::uint64_t FrameSchedule::frame_count() const noexcept {
    return static_cast<std::uint64_t>(std::floor(shown_duration() * frames_per_second * (1.0 + kRounding))) + 1;
}

std::uint64_t FrameSchedule::step_of_frame(std::uint64_t frame) const noexcept {
    if (slow.empty())
        return static_cast<std::uint64_t>(
            std::llround(static_cast<double>(frame) * steps_per_second / frames_per_second));
    return nearest_step(std::min(moment_of_frame(frame).time, duration), steps_per_second);
}

double FrameSchedule::speed_of_frame(std::uint64_t frame) const noexcept { return moment_of_frame(frame).speed; }

bool FrameSchedule::repeats_frames() const noexcept {
    double slowest = 1.0;
    for (const SlowMotion& part : slow)
        if (part.from < duration) slowest = std::min(slowest, part.speed);
    return frames_per_second > slowest * steps_per_second * (1.0 + kRounding);
}

double FrameSchedule::shown_duration() const noexcept {
    double shown = duration;
    for (const SlowMotion& part : slow)
        shown += std::max(std::min(part.to, duration) - part.from, 0.0) * (1.0 / part.speed - 1.0);
    return shown;
}

// The parts before the frame take from its time on screen what they are longer than in the simulation.
FrameSchedule::Moment FrameSchedule::moment_of_frame(std::uint64_t frame) const noexcept {
    double time = static_cast<double>(frame) / frames_per_second;
    for (const SlowMotion& part : slow) {
        if (time * (1.0 + kRounding) < part.from) break;
        const double shown = (part.to - part.from) / part.speed;
        if (time * (1.0 + kRounding) < part.from + shown)
            return {part.from + std::max(time - part.from, 0.0) * part.speed, part.speed};
        time -= shown - (part.to - part.from);
    }
    return {time, 1.0};
}

}  // namespace tumble::tools
