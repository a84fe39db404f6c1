// The number of lanes in an array of lanes, for code that counts lanes and computes with none.
#pragma once

namespace tumble {

inline constexpr int kLaneCount = 8;

}  // namespace tumble
