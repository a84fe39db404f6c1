// Angles of scene files and drawings are degrees, those of worlds radians.
#pragma once

#include "tumble/math.hpp"

namespace tumble::scene {

inline constexpr double kRadians = kPi / 180.0;  // of a degree
inline constexpr double kDegrees = 180.0 / kPi;  // of a radian

}  // namespace tumble::scene
