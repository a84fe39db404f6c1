// Orientation by a filter in double, and by an exact sum where the filter cannot decide.
//
// The product of two floats is exact in double (48 bits), so the determinant is a sum of six doubles; its sign comes
// from an expansion grown without error, as in Shewchuk, Adaptive Precision Floating-Point Arithmetic, 1997, section 2.
#include "shape/orientation.hpp"

#include <array>
#include <cmath>

#include "debug/check.hpp"

namespace tumble {

namespace {

int sign(double value) { return (value > 0.0) - (value < 0.0); }

// The sign of the exact sum. The expansion's parts do not overlap and grow in size, so the last nonzero one decides.
int sign_of_sum(const std::array<double, 6>& terms) {
    std::array<double, 6> expansion{};
    std::size_t count = 0;
    for (const double term : terms) {
        double carry = term;
        for (std::size_t part = 0; part < count; ++part) {
            const double sum = carry + expansion[part];
            const double virtual_part = sum - carry;
            expansion[part] = (carry - (sum - virtual_part)) + (expansion[part] - virtual_part);
            carry = sum;
        }
        TUMBLE_CHECK(count < expansion.size());
        expansion[count++] = carry;
    }
    for (std::size_t part = count; part-- > 0;)
        if (expansion[part] != 0.0) return sign(expansion[part]);
    return 0;
}

}  // namespace

int orientation(Vec2 a, Vec2 b, Vec2 c) {
    const DVec2 pa(a), pb(b), pc(c);
    const DVec2 ab = pb - pa, ac = pc - pa;
    const double left = ab.x * ac.y, right = ab.y * ac.x;
    // Each product carries three roundings and their difference a fourth: 4 * 2^-53 (|left| + |right|), doubled.
    if (std::abs(left - right) > 0x1p-50 * (std::abs(left) + std::abs(right))) return sign(left - right);
    return sign_of_sum({pa.x * pb.y, -(pa.y * pb.x), pb.x * pc.y, -(pb.y * pc.x), pc.x * pa.y, -(pc.y * pa.x)});
}

}  // namespace tumble
