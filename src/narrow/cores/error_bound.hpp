// The error bound E of a core distance: the one constant of the proof. ERROR_BOUND.md derives it step by step.
//
// E = 16 u S with u = 2^-53 and S = |qA| RA + |qB| RB + |p| (CorePair::scale): the computed |v| of a simplex, -h / |d|
// of a direction and separation of a face each differ from the exact one by less.
#pragma once

#include "narrow/cores/core_pair.hpp"
#include "simd/lane_function.hpp"

namespace tumble {

inline constexpr double kUnitRoundoff = 0x1p-53;

// For one scale, or for a lane of scales.
template <typename Number>
TUMBLE_LANE_FUNCTION Number error_bound(const Number& scale) {
    return 16.0 * kUnitRoundoff * scale;
}
inline double error_bound(const CorePair& pair) { return error_bound(pair.scale); }

// GJK stops if a new support vertex is nearer to the origin than the simplex by no more than its own rounding.
template <typename Number>
TUMBLE_LANE_FUNCTION Number progress_bound(const Number& scale) {
    return 4.0 * kUnitRoundoff * scale;
}
inline double progress_bound(const CorePair& pair) { return progress_bound(pair.scale); }

}  // namespace tumble
