// The states of one run as an array [step, body, 6]: x, y (m), angle (rad), vx, vy (m/s), angular velocity (rad/s).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace tumble::sweep {

inline constexpr std::size_t kStateNumbers = 6;

struct TrajectoryArray {
    std::size_t steps = 0, bodies = 0;
    std::vector<double> numbers{};  // NaN for a body that does not exist at that time
};

// As a .npy file, version 1.0, little-endian, with `bits` (32 or 64) for a number.
std::string to_npy(const TrajectoryArray& trajectory, int bits);

}  // namespace tumble::sweep
