// Times of a scene, which are decimal fractions of a second, and steps, which are not.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace tumble::scene {

inline constexpr double kTimeSlack = 1e-6;  // of a step: a time so little before a step is meant to be at it

// The first step that begins at the time (s) or later.
inline std::uint64_t first_step_at(double time, double steps_per_second) {
    return static_cast<std::uint64_t>(std::max(0.0, std::ceil(time * steps_per_second - kTimeSlack)));
}

}  // namespace tumble::scene
