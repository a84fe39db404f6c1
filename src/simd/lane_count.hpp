// The number of lanes in an array of float lanes, for code that does not include Eigen (lanes.hpp).
#pragma once

namespace tumble {

inline constexpr int kLaneCount = 8;

}  // namespace tumble
