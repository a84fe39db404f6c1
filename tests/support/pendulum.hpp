// The exact period of a pendulum.
#pragma once

#include <cmath>

#include "tumble/math.hpp"

namespace tumble::test {

// Of any amplitude (rad): 2 pi sqrt(L / g) / agm(1, cos(amplitude / 2)), s. The length L is in m, the gravity g in
// m/s^2.
inline double pendulum_period(double length, double amplitude, double gravity = 10.0) {
    double a = 1.0, b = std::cos(amplitude / 2.0);
    for (int i = 0; i < 8; ++i) {
        const double mean = (a + b) / 2.0;
        b = std::sqrt(a * b);
        a = mean;
    }
    return 2.0 * kPi * std::sqrt(length / gravity) / a;
}

}  // namespace tumble::test
