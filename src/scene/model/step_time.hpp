// From the times of a scene, which are decimal fractions of a second, to steps, which are not.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace tumble::scene {

// Of a step: a time that is later than the start of a step by less than this counts as that start.
inline constexpr double kTimeSlack = 1e-6;

// The first step that begins at the time (s) or later.
inline std::uint64_t first_step_at(double time, double steps_per_second) {
    return static_cast<std::uint64_t>(std::max(0.0, std::ceil(time * steps_per_second - kTimeSlack)));
}

}  // namespace tumble::scene
