// Angles that are probably meant in radians: those of programs are, those of scene files are degrees.
#include <algorithm>
#include <array>
#include <cmath>

#include "scene/json/problem_codes.hpp"
#include "scene/lint/lint.hpp"
#include "scene/model/display.hpp"
#include "tumble/math.hpp"

namespace tumble::scene {

namespace {

// The multiples of pi / 12 that people write: 30, 45, 60, 90, 120, 135, 150, 180, 270 and 360 degrees.
constexpr std::array<double, 10> kTwelfths{2, 3, 4, 6, 8, 9, 10, 12, 18, 24};
constexpr double kRounded = 6e-4;  // relative: 1.57 for pi / 2, 3.14 for pi
constexpr double kExact = 1e-6;    // relative: of a number with more than four decimals

bool has_four_decimals(double number) { return std::abs(1e4 * number - std::round(1e4 * number)) < 1e-6; }

bool seems_to_be_radians(double degrees) {
    const double twelfths = std::abs(degrees) / (kPi / 12.0), nearest = std::round(twelfths);
    const double off = has_four_decimals(degrees) ? kRounded : kExact;
    return std::ranges::count(kTwelfths, nearest) > 0 && std::abs(twelfths - nearest) < off * nearest;
}

}  // namespace

void lint_degrees(double degrees, const std::string& pointer, Diagnostics& diagnostics) {
    if (!seems_to_be_radians(degrees)) return;
    const double meant = std::copysign(15.0 * std::round(std::abs(degrees) / (kPi / 12.0)), degrees);
    diagnostics.warning(codes::radians, pointer,
                        "the angle is " + brief(degrees) + " degrees, and looks like one in radians",
                        "if it is meant in radians, write " + brief(meant));
}

}  // namespace tumble::scene
