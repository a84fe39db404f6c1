// The sine and cosine of an angle that grows, from those that it had: without the wait for a reduction.
#pragma once

#include "tumble/math.hpp"

namespace tumble {

// Of the angle of `start` plus `radians` (absolute error below that of `start` + 6e-16; NaN for more than 1e6).
SinCos turned(SinCos start, double radians);

}  // namespace tumble
