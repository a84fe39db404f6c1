// Sine, cosine and arc tangent by argument reduction and series, in plain double arithmetic without fused operations.
// They have the same bits on every platform, which the C library does not guarantee.
#include "tumble/math.hpp"

#include "math/turned.hpp"

namespace tumble {

namespace {

// pi / 2 as the sum of a head of 33 bits and its tail: k * head is exact for |k| < 2^20 (Cody and Waite).
constexpr double kHalfPiHead = 0x1.921fb544p+0;
constexpr double kHalfPiTail = 0x1.0b4611a626331p-34;
constexpr double kLargestAngle = 1e6;

// Sine and cosine in two lanes: each operation rounds as for a scalar.
using Double2 = double __attribute__((vector_size(16)));

// Taylor series on [-pi/4, pi/4]: (sin x - x) / x^3 and (cos x - 1 + x^2 / 2) / x^4 as series in x^2. The first term
// left out is below 1e-19 and 3e-18.
constexpr Double2 kSeries[] = {{1.0 / 355687428096000.0, 0.0},  // 1 / 17!
                               {-1.0 / 1307674368000.0, 1.0 / 20922789888000.0},
                               {1.0 / 6227020800.0, -1.0 / 87178291200.0},
                               {-1.0 / 39916800.0, 1.0 / 479001600.0},
                               {1.0 / 362880.0, -1.0 / 3628800.0},
                               {-1.0 / 5040.0, 1.0 / 40320.0},
                               {1.0 / 120.0, -1.0 / 720.0},
                               {-1.0 / 6.0, 1.0 / 24.0}};  // 1 / 3!, 1 / 4!

// Sine and cosine of x from the two sums of the series; z = x^2.
SinCos from_series(double x, double z, Double2 sum) {
    return {x + x * (z * sum[0]), 1.0 - (0.5 * z - z * (z * sum[1]))};
}

SinCos reduced_sin_cos(double x) {
    const double z = x * x;
    const Double2 zz{z, z};
    Double2 sum = kSeries[0];
    for (int i = 1; i < 8; ++i) sum = zz * sum + kSeries[i];
    return from_series(x, z, sum);
}

// The same series by Estrin's scheme [Estrin 1960]: half the latency, and other roundings.
SinCos small_sin_cos(double x) {
    const double z = x * x;
    const Double2 z1{z, z}, z2 = z1 * z1, z4 = z2 * z2;
    const Double2 high = (kSeries[0] * z1 + kSeries[1]) * z2 + (kSeries[2] * z1 + kSeries[3]);
    const Double2 low = (kSeries[4] * z1 + kSeries[5]) * z2 + (kSeries[6] * z1 + kSeries[7]);
    return from_series(x, z, high * z4 + low);
}

// Sine and cosine of an angle larger by quarter turns. Without branches, as the number of quarters is unpredictable.
SinCos add_quarter_turns(SinCos v, long quarters) {
    const double by_parity[2][2] = {{v.sin, v.cos}, {v.cos, v.sin}};
    constexpr double kSign[2] = {1.0, -1.0};
    const double(&of)[2] = by_parity[quarters & 1];
    return {kSign[quarters >> 1 & 1] * of[0], kSign[(quarters + 1) >> 1 & 1] * of[1]};
}

Rotation to_rotation(SinCos v) { return {static_cast<float>(v.cos), static_cast<float>(v.sin)}; }

}  // namespace

SinCos sin_cos(double radians) {
    if (!(std::abs(radians) <= kLargestAngle)) {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        return {nan, nan};
    }
    const double quarters = std::nearbyint(radians * (2.0 / kPi));
    const double reduced = (radians - quarters * kHalfPiHead) - quarters * kHalfPiTail;
    return add_quarter_turns(reduced_sin_cos(reduced), static_cast<long>(quarters));
}

SinCos turned(SinCos start, double radians) {
    const SinCos turn = std::abs(radians) <= kPi / 4.0 ? small_sin_cos(radians) : sin_cos(radians);
    return {start.sin * turn.cos + start.cos * turn.sin, start.cos * turn.cos - start.sin * turn.sin};
}

double arc_tangent(double y, double x) {
    if (!std::isfinite(x) || !std::isfinite(y)) return std::numeric_limits<double>::quiet_NaN();
    const double ax = std::abs(x), ay = std::abs(y);
    // Comparisons in place of std::fmax, which is a call, and a factor in place of a branch that half of all angles
    // take.
    const double larger = ax > ay ? ax : ay;
    if (larger == 0.0) return 0.0;
    const double t = (ax > ay ? ay : ax) / larger;
    // A quadratic guess g for atan(t), t in [0, 1], is within 0.0016 rad; the rest is the angle between (1, t) and
    // (cos g, sin g), small enough for three terms of its series (the fourth is below 3e-21).
    const double guess = t * (kPi / 4.0 + (1.0 - t) * (0.2447 + 0.0663 * t));
    const SinCos g = reduced_sin_cos(guess);  // the guess is at most pi / 4
    const double rest = (t * g.cos - g.sin) / (g.cos + t * g.sin);
    const double rest_sq = rest * rest;
    double angle = guess + rest * (1.0 - rest_sq * (1.0 / 3.0 - rest_sq * (1.0 / 5.0)));
    if (ay > ax) angle = kPi / 2.0 - angle;
    if (x < 0.0) angle = kPi - angle;
    const double sign = y < 0.0 ? -1.0 : 1.0;
    return sign * angle;
}

SinCos sin_cos_degrees(double degrees) {
    const double turn = std::fmod(degrees, 360.0);
    const double quarters = std::nearbyint(turn / 90.0);
    const SinCos v = sin_cos((turn - 90.0 * quarters) * (kPi / 180.0));
    return add_quarter_turns(v, std::isfinite(quarters) ? static_cast<long>(quarters) : 0);
}

Rotation make_rotation(double radians) { return to_rotation(sin_cos(radians)); }

Rotation make_rotation_degrees(double degrees) { return to_rotation(sin_cos_degrees(degrees)); }

double angle(Rotation q) { return arc_tangent(q.s, q.c); }

}  // namespace tumble
