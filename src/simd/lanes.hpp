// Eight float lanes as an Eigen array, and the operations that Eigen does not compile to packed code.
//
// Sums, products and quotients of whole arrays are packed on every instruction set and give the same bits on all of
// them (no contraction). `(a < b).select(x, y)` is not packed, nor is `.sqrt()` with AVX-512: use select_less() and
// square_root(). `.max()` and `.min()` of 0 and -0 differ between processors: use larger() and smaller(). Reductions
// (.sum(), .dot()) depend on the width of a register and are forbidden in anything that reaches the state. Give every
// intermediate result its type: `auto` would store an Eigen expression, which may outlive its operands.
#pragma once

#include <Eigen/Core>
#include <cstring>

#include "simd/lane_count.hpp"
#include "simd/lane_function.hpp"

namespace tumble {

using Lanes = Eigen::Array<float, kLaneCount, 1>;

namespace simd {

// The widest register of the target that divides eight floats evenly: 8 with AVX, 4 with SSE2.
using Packet = Eigen::internal::find_best_packet<float, kLaneCount>::type;
inline constexpr int kPacketSize = Eigen::internal::unpacket_traits<Packet>::size;
static_assert(kLaneCount % kPacketSize == 0);

}  // namespace simd

// For each lane: a < b ? x : y. A NaN in a or b selects y.
TUMBLE_LANE_FUNCTION Lanes select_less(const Lanes& a, const Lanes& b, const Lanes& x, const Lanes& y) {
    using namespace Eigen::internal;
    Lanes result;
    for (int i = 0; i < kLaneCount; i += simd::kPacketSize) {
        const simd::Packet mask = pcmp_lt(ploadu<simd::Packet>(a.data() + i), ploadu<simd::Packet>(b.data() + i));
        pstoreu(result.data() + i,
                pselect(mask, ploadu<simd::Packet>(x.data() + i), ploadu<simd::Packet>(y.data() + i)));
    }
    return result;
}

// Correctly rounded in every lane, as Eigen's approximations are off.
static_assert(EIGEN_FAST_MATH == 0);
TUMBLE_LANE_FUNCTION Lanes square_root(const Lanes& a) {
    using namespace Eigen::internal;
    Lanes result;
    for (int i = 0; i < kLaneCount; i += simd::kPacketSize)
        pstoreu(result.data() + i, psqrt(ploadu<simd::Packet>(a.data() + i)));
    return result;
}

// Converts lanes that hold the bits of integers to floats.
TUMBLE_LANE_FUNCTION Lanes from_integers(const Lanes& bits) {
    Eigen::Array<int, kLaneCount, 1> integers;
    std::memcpy(integers.data(), bits.data(), sizeof integers);
    return integers.cast<float>();
}

// True if a < b in any lane.
TUMBLE_LANE_FUNCTION bool any_less(const Lanes& a, const Lanes& b) {
    using namespace Eigen::internal;
    bool result = false;
    for (int i = 0; i < kLaneCount; i += simd::kPacketSize)
        result |= predux_any(pcmp_lt(ploadu<simd::Packet>(a.data() + i), ploadu<simd::Packet>(b.data() + i)));
    return result;
}

// For each lane the larger number. Of equal numbers (0 and -0 are), and if one is NaN, it is a. An x86 processor has
// one instruction that does this; that of aarch64 takes 0 for larger than -0.
TUMBLE_LANE_FUNCTION Lanes larger(const Lanes& a, const Lanes& b) {
#if defined(__SSE2__)
    return a.max(b);
#else
    return select_less(a, b, b, a);
#endif
}

// For each lane the smaller number, else as larger().
TUMBLE_LANE_FUNCTION Lanes smaller(const Lanes& a, const Lanes& b) {
#if defined(__SSE2__)
    return a.min(b);
#else
    return select_less(b, a, b, a);
#endif
}

// Every lane limited to [-limit, limit], limit >= 0.
TUMBLE_LANE_FUNCTION Lanes clamp_magnitude(const Lanes& value, const Lanes& limit) {
    const Lanes negative = -limit;
    return smaller(larger(value, negative), limit);
}

}  // namespace tumble
