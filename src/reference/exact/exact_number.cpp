#include "reference/exact/exact_number.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "debug/check.hpp"
namespace tumble::reference {

namespace {

struct Parts {
    std::int64_t mantissa = 0;  // odd, or 0
    int exponent = kZeroExponent;
};

Parts split(double value) {
    if (value == 0.0) return {};
    int exponent = 0;
    const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
    const int zeros = std::countr_zero(static_cast<std::uint64_t>(mantissa));
    return {mantissa / (std::int64_t{1} << zeros), exponent - 53 + zeros};
}

// x * 2^shift, rounded down for a negative shift.
mpz_class shifted(const mpz_class& x, int shift) {
    mpz_class result;
    if (shift >= 0) {
        mpz_mul_2exp(result.get_mpz_t(), x.get_mpz_t(), static_cast<mp_bitcnt_t>(shift));
    } else {
        mpz_fdiv_q_2exp(result.get_mpz_t(), x.get_mpz_t(), static_cast<mp_bitcnt_t>(-shift));
    }
    return result;
}

int bit_length(const mpz_class& x) { return x == 0 ? 0 : static_cast<int>(mpz_sizeinbase(x.get_mpz_t(), 2)); }

// mantissa * 2^exponent to the nearest double. 55 bits, the last one set if any dropped bit is, round like all bits.
double round_to_double(const mpz_class& mantissa, int exponent) {
    mpz_class magnitude = abs(mantissa);
    const int excess = bit_length(magnitude) - 55;
    if (excess > 0) {
        const bool inexact = mpz_scan1(magnitude.get_mpz_t(), 0) < static_cast<mp_bitcnt_t>(excess);
        magnitude = shifted(magnitude, -excess);
        if (inexact) mpz_setbit(magnitude.get_mpz_t(), 0);
        exponent += excess;
    }
    const double rounded = static_cast<double>(mpz_get_ui(magnitude.get_mpz_t()));
    return std::ldexp(sgn(mantissa) < 0 ? -rounded : rounded, exponent);
}

}  // namespace

int lowest_bit_exponent(double value) { return split(value).exponent; }

mpz_class scaled(double value, int exponent) {
    const Parts parts = split(value);
    if (parts.mantissa == 0) return 0;
    TUMBLE_CHECK(exponent <= parts.exponent);
    return shifted(mpz_class(parts.mantissa), parts.exponent - exponent);
}

ExactDyadic exact_sum(std::initializer_list<double> values) {
    int exponent = kZeroExponent;
    for (const double value : values) exponent = std::min(exponent, lowest_bit_exponent(value));
    if (exponent == kZeroExponent) return {};
    mpz_class sum = 0;
    for (const double value : values) sum += scaled(value, exponent);
    return {sum, exponent};
}

int compare(const SignedRoot& x, const ExactDyadic& y) {
    TUMBLE_CHECK(sgn(x.denominator) > 0);
    const int y_sign = sgn(y.mantissa);
    if (x.sign != y_sign) return x.sign > y_sign ? 1 : -1;
    // |x| ? |y|: numerator * 2^(2 ex) ? mantissa^2 * denominator * 2^(2 ey)
    const int shift = 2 * (x.exponent - y.exponent);
    const mpz_class left = shifted(x.numerator, std::max(shift, 0));
    const mpz_class right = shifted(y.mantissa * y.mantissa * x.denominator, std::max(-shift, 0));
    const int order = cmp(left, right);
    return x.sign * ((order > 0) - (order < 0));
}

int compare(const SignedRoot& x, const SignedRoot& y) {
    TUMBLE_CHECK(x.exponent == y.exponent);
    if (x.sign != y.sign) return x.sign > y.sign ? 1 : -1;
    const int order = cmp(x.numerator * y.denominator, y.numerator * x.denominator);
    return x.sign * ((order > 0) - (order < 0));
}

double rounded_difference(const SignedRoot& x, const ExactDyadic& y) {
    TUMBLE_CHECK(sgn(x.denominator) > 0);
    if (x.sign == 0) return round_to_double(-y.mantissa, y.exponent);
    const int x_top = x.exponent + (bit_length(x.numerator) - bit_length(x.denominator)) / 2;
    const int y_top = sgn(y.mantissa) == 0 ? x_top : y.exponent + bit_length(y.mantissa);
    const int unit = std::min(std::max(x_top, y_top) - 256, y.mantissa == 0 ? x_top : y.exponent);
    // The root in units of 2^unit: sqrt(numerator * 2^(2 (exponent - unit)) / denominator).
    const int shift = 2 * (x.exponent - unit);
    mpz_class quotient = shifted(x.numerator, std::max(shift, 0)) / shifted(x.denominator, std::max(-shift, 0));
    const mpz_class root = sqrt(quotient);
    const mpz_class signed_root = x.sign < 0 ? mpz_class(-root) : root;
    return round_to_double(signed_root - shifted(y.mantissa, sgn(y.mantissa) == 0 ? 0 : y.exponent - unit), unit);
}

}  // namespace tumble::reference
