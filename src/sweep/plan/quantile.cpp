// The functions of libm give other last bits on other machines: these are made of arithmetic and of exponential().
#include "sweep/plan/quantile.hpp"

#include <cmath>

#include "scene/expressions/exponential.hpp"

namespace tumble::sweep {

namespace {

constexpr double kLogarithmOf2 = 0.69314718055994530942;
constexpr double kHalfLogarithmOf2Pi = 0.91893853320467274178;
constexpr double kFarthestNormal = 9.0;  // the probability beyond is 1e-19
constexpr int kMostTerms = 300;          // of the series, at 9: the terms grow up to the 40th, and are below 1e-16 then

// The probability of a normal number below x, by the series x + x^3/3 + x^5/(3*5) + ... (Marsaglia 2004, "Evaluating
// the normal distribution").
double normal_probability(double x) {
    double sum = x, term = x;
    for (int i = 1; i < kMostTerms && sum + term != sum; ++i) {
        term *= x * x / (2.0 * i + 1.0);
        sum += term;
    }
    return 0.5 + sum * scene::exponential(-0.5 * x * x - kHalfLogarithmOf2Pi);
}

}  // namespace

double natural_logarithm(double x) {
    int exponent = 0;
    const double fraction = std::frexp(x, &exponent);  // in [0.5, 1)
    double y = fraction - 1.0;
    // Halley's iteration for e^y = fraction; the error is cubed each time, and is at most 0.2 at first.
    for (int i = 0; i < 4; ++i) {
        const double power = scene::exponential(y);
        y += 2.0 * (fraction - power) / (fraction + power);
    }
    return y + exponent * kLogarithmOf2;
}

double normal_quantile(double u) {
    double lower = -kFarthestNormal, upper = kFarthestNormal;
    while (true) {
        const double middle = 0.5 * (lower + upper);
        if (middle <= lower || middle >= upper || upper - lower < 1e-15) return middle;
        (normal_probability(middle) < u ? lower : upper) = middle;
    }
}

}  // namespace tumble::sweep
