// Intervals of long double that contain an exact number, to decide most comparisons without exact arithmetic.
#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <optional>

namespace tumble::reference {

// The unit roundoff of long double: 2^-64 on x86-64.
inline constexpr long double kLongRoundoff = std::numeric_limits<long double>::epsilon() / 2;

// Contains the exact number; the whole line by default.
struct Interval {
    long double low = -std::numeric_limits<long double>::infinity();
    long double high = std::numeric_limits<long double>::infinity();
};

inline Interval interval_about(long double value, long double error) { return {value - error, value + error}; }

// The sign of x - y if the intervals are apart; never 0.
inline std::optional<int> compare(Interval x, Interval y) {
    if (x.low > y.high) return 1;
    if (x.high < y.low) return -1;
    return std::nullopt;
}

// Of the exact sum. With u the unit roundoff, n - 1 additions of n numbers x round by at most (n - 1) u sum |x|, to
// first order. Two more for the terms of second order and the rounding of the ends.
inline Interval interval_sum(std::initializer_list<double> values) {
    long double sum = 0.0L, magnitude = 0.0L;
    for (const long double value : values) {
        sum += value;
        magnitude += std::abs(value);
    }
    return interval_about(sum, static_cast<long double>(values.size() + 1) * kLongRoundoff * magnitude);
}

}  // namespace tumble::reference
