// Comparisons with a tolerance that the test states: CHECK(near(actual, expected, relative(1e-6))).
// A failure prints both values, their difference and the tolerance. A value that is exact is compared with ==.
// The tolerances are those of Catch2, WithinAbs and WithinRel; a relative one is a part of the expected value alone, so
// that it allows nothing at an expected value of 0.
#pragma once

#include <doctest/doctest.h>

#include <cmath>
#include <sstream>

namespace tumble::test {

struct Tolerance {
    double absolute = 0.0;
    double relative = 0.0;  // part of |expected|
};

constexpr Tolerance absolute(double tolerance) { return {tolerance, 0.0}; }
constexpr Tolerance relative(double part) { return {0.0, part}; }

// The result of a few float operations: 16 roundings by 2^-24 of it each; and of as many double ones.
inline constexpr Tolerance kFloat = relative(16 * 0x1p-24);
inline constexpr Tolerance kDouble = relative(16 * 0x1p-53);

// A sum of n floats of one sign: each addition rounds by at most 2^-24 of the result.
constexpr Tolerance float_sum(int n) { return relative(n * 0x1p-24); }

struct Comparison {
    double actual, expected, tolerance;

    // False with a NaN. Infinities are near if they are equal.
    explicit operator bool() const { return actual == expected || std::abs(actual - expected) <= tolerance; }
};

inline Comparison near(double actual, double expected, Tolerance tolerance) {
    return {actual, expected, tolerance.absolute + tolerance.relative * std::abs(expected)};
}

inline doctest::String toString(const Comparison& comparison) {
    std::ostringstream text;
    text.precision(17);
    text << comparison.actual << " near " << comparison.expected;
    text.precision(3);
    text << ", difference " << comparison.actual - comparison.expected << ", tolerance " << comparison.tolerance;
    return text.str().c_str();
}

}  // namespace tumble::test
