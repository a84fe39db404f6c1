// The trigonometry of math.hpp against the 64-bit-mantissa libm of long double.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "math/turned.hpp"
#include "support/near.hpp"
#include "tumble/math.hpp"

using namespace tumble;
using namespace tumble::test;

TEST_CASE("sine and cosine are within 4e-16 up to 1e6 radians") {
    std::mt19937_64 random(1);
    double worst = 0.0;
    for (const double range : {1e-9, 1e-3, 1.0, 10.0, 1e3, 1e6}) {
        std::uniform_real_distribution<double> angles(-range, range);
        for (int sample = 0; sample < 100000; ++sample) {
            const double x = angles(random);
            const SinCos v = sin_cos(x);
            const long double exact = x;
            worst = std::max(worst, static_cast<double>(std::abs(v.sin - std::sin(exact))));
            worst = std::max(worst, static_cast<double>(std::abs(v.cos - std::cos(exact))));
        }
    }
    CHECK(worst < 4e-16);
    CHECK(worst > 1e-17);  // the comparison sees rounding: it is not a comparison of a thing with itself
}

TEST_CASE("turned() adds an error below 6e-16, and none for an angle of 0") {
    std::mt19937_64 random(3);
    double worst = 0.0;
    for (const double range : {1e-9, 0.1, kPi / 4.0, 1.0, 10.0, 1e6}) {
        std::uniform_real_distribution<double> angles(-4.0, 4.0), turns(-range, range);
        for (int sample = 0; sample < 50000; ++sample) {
            const double angle = angles(random), turn = turns(random);
            const SinCos start = sin_cos(angle), v = turned(start, turn);
            // By the angle sum formulas, as the sum of the angles would round.
            const long double sin_a = std::sin(static_cast<long double>(angle)),
                              cos_a = std::cos(static_cast<long double>(angle));
            const long double sin_t = std::sin(static_cast<long double>(turn)),
                              cos_t = std::cos(static_cast<long double>(turn));
            const double of_start = static_cast<double>(std::hypot(start.sin - sin_a, start.cos - cos_a));
            worst = std::max(worst, static_cast<double>(std::abs(v.sin - (sin_a * cos_t + cos_a * sin_t))) - of_start);
            worst = std::max(worst, static_cast<double>(std::abs(v.cos - (cos_a * cos_t - sin_a * sin_t))) - of_start);
            REQUIRE(turned(start, 0.0).sin == start.sin);
            REQUIRE(turned(start, 0.0).cos == start.cos);
        }
    }
    CHECK(worst < 6e-16);
    CHECK(worst > 1e-17);
    CHECK(std::isnan(turned(SinCos{}, 2e6).sin));
}

TEST_CASE("sine keeps its relative accuracy near zero") {
    for (const double x : {1e-300, 1e-12, 1e-5, -1e-5}) CHECK(near(sin_cos(x).sin, std::sin(x), relative(1e-15)));
    CHECK(sin_cos(0.0).sin == 0.0);
    CHECK(sin_cos(0.0).cos == 1.0);
}

TEST_CASE("the arc tangent is within 6e-16 relative in every octant") {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> exponent(-12.0, 12.0);
    double worst = 0.0;
    for (int sample = 0; sample < 400000; ++sample) {
        const double x = ((sample & 1) ? -1.0 : 1.0) * std::pow(10.0, exponent(random) / ((sample & 4) ? 1.0 : 50.0));
        const double y = (sample & 2) ? -1.0 : 1.0;
        const long double exact = std::atan2(static_cast<long double>(y), static_cast<long double>(x));
        worst = std::max(worst, static_cast<double>(std::abs((arc_tangent(y, x) - exact) / exact)));
    }
    CHECK(worst < 6e-16);
}

TEST_CASE("the arc tangent is exact on the axes") {
    CHECK(arc_tangent(0.0, 0.0) == 0.0);
    CHECK(arc_tangent(0.0, 5.0) == 0.0);
    CHECK(arc_tangent(0.0, -5.0) == kPi);
    CHECK(arc_tangent(3.0, 0.0) == kPi / 2.0);
    CHECK(arc_tangent(-3.0, 0.0) == -kPi / 2.0);
    CHECK(near(arc_tangent(1e308, 1e308), kPi / 4.0, relative(1e-15)));
}

TEST_CASE("angles that are not finite or too large give NaN") {
    CHECK(std::isnan(sin_cos(INFINITY).sin));
    CHECK(std::isnan(sin_cos(NAN).cos));
    CHECK(std::isnan(sin_cos(2e6).sin));
    CHECK(std::isnan(arc_tangent(NAN, 1.0)));
    CHECK(std::isnan(arc_tangent(1.0, INFINITY)));
    CHECK(std::isnan(make_rotation_degrees(NAN).c));
}

TEST_CASE("multiples of 90 degrees are exact") {
    CHECK(sin_cos_degrees(90.0).cos == 0.0);
    CHECK(sin_cos_degrees(-180.0).sin == 0.0);
    CHECK(sin_cos_degrees(-180.0).cos == -1.0);
    CHECK(near(sin_cos_degrees(30.0).sin, 0.5, relative(1e-15)));
    CHECK(make_rotation_degrees(0.0) == Rotation{1.0f, 0.0f});
    CHECK(make_rotation_degrees(90.0) == Rotation{0.0f, 1.0f});
    CHECK(make_rotation_degrees(-180.0) == Rotation{-1.0f, 0.0f});
    CHECK(make_rotation_degrees(270.0) == Rotation{0.0f, -1.0f});
    CHECK(make_rotation_degrees(360e6 + 90.0) == Rotation{0.0f, 1.0f});
}

TEST_CASE("angle() is the inverse of make_rotation()") {
    for (double degrees = -179.0; degrees <= 180.0; degrees += 1.0)
        CHECK(near(angle(make_rotation_degrees(degrees)), degrees * kPi / 180.0, absolute(0x1p-24)));
}

TEST_CASE("inverse_rotate() undoes rotate(), and perp() rotates by 90 degrees") {
    const Vec2 v{3.0f, -2.0f};
    const Rotation q = make_rotation(0.7);
    CHECK(length(inverse_rotate(q, rotate(q, v)) - v) < 1e-6f);
    CHECK(rotate(make_rotation_degrees(90.0), v) == perp(v));
    CHECK(cross(v, perp(v)) == length_sq(v));
}
