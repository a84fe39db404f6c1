// Exact numbers of the oracle: dyadic sums and signed square roots of rationals, compared without rounding.
//
// Every input is a float or a double, hence an integer times a power of two, and so are sums and products. Distances
// are square roots of quotients of these, and their squares are compared. Integers are GMP's.
#pragma once

#include <gmpxx.h>

#include <initializer_list>

namespace tumble::reference {

// The value mantissa * 2^exponent.
struct ExactDyadic {
    mpz_class mantissa = 0;
    int exponent = 0;
};

// The largest e for which value / 2^e is an integer; kZeroExponent for 0. The value must be finite.
int lowest_bit_exponent(double value);
inline constexpr int kZeroExponent = 1 << 20;

// value / 2^exponent, for an exponent that is at most lowest_bit_exponent(value).
mpz_class scaled(double value, int exponent);

ExactDyadic exact_sum(std::initializer_list<double> values);

// The number sign * sqrt(numerator / denominator) * 2^exponent; numerator >= 0, denominator > 0, sign 0 only for 0.
struct SignedRoot {
    int sign = 0;
    mpz_class numerator = 0;
    mpz_class denominator = 1;
    int exponent = 0;
};

// The sign of x - y, decided exactly. The second form needs equal exponents.
int compare(const SignedRoot& x, const ExactDyadic& y);
int compare(const SignedRoot& x, const SignedRoot& y);

// x - y to the nearest double, with the root taken to 256 bits below the larger of the two.
double rounded_difference(const SignedRoot& x, const ExactDyadic& y);

}  // namespace tumble::reference
