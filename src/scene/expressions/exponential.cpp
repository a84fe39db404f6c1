// e^x = 2^k e^r with |r| <= log(2) / 2, and the series of e^r (Cody and Waite 1980 for the reduction in two parts).
#include "scene/expressions/exponential.hpp"

#include <cmath>
#include <limits>

namespace tumble::scene {

double exponential(double x) {
    constexpr double kOverflow = 710.0, kUnderflow = -746.0;
    constexpr double kLog2High = 0x1.62e42fee00000p-1, kLog2Low = 0x1.a39ef35793c76p-33;  // their sum is log(2)
    constexpr int kTerms = 14;                                                            // r^14 / 14! < 5e-18
    if (std::isnan(x)) return x;
    if (x > kOverflow) return std::numeric_limits<double>::infinity();
    if (x < kUnderflow) return 0.0;
    const double k = std::floor(x / (kLog2High + kLog2Low) + 0.5);
    const double r = (x - k * kLog2High) - k * kLog2Low;
    double sum = 1.0;
    for (int i = kTerms; i > 0; --i) sum = 1.0 + r * sum / i;
    return std::ldexp(sum, static_cast<int>(k));
}

}  // namespace tumble::scene
