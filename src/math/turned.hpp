// Sine and cosine of a changed angle from those of the old one, without argument reduction for small changes.
#pragma once

#include "tumble/math.hpp"

namespace tumble {

// Sine and cosine of the angle of `start` plus `radians`. The absolute error is below that of `start` + 6e-16; NaN for
// |radians| > 1e6.
SinCos turned(SinCos start, double radians);

}  // namespace tumble
