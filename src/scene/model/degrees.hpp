// Angles are degrees in scene files and drawings, radians in worlds.
#pragma once

#include "tumble/math.hpp"

namespace tumble::scene {

inline constexpr double kRadians = kPi / 180.0;  // of a degree
inline constexpr double kDegrees = 180.0 / kPi;  // of a radian

}  // namespace tumble::scene
