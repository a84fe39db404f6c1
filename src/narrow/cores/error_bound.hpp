// How far rounding can carry the core distance: the one constant of the proof, by running error analysis.
//
// u = 2^-53, R = |qA| RA + |qB| RB, p the offset, S = R + |p| (CorePair::scale). Every input is float or double and
// taken literally. First-order terms; the second-order ones are below u of them.
//
// A vertex w = (a - b) - p: a and b round once a coordinate (products of floats are exact), as do a - b, p, and w:
//     |err w| <= u (RA + RB) + u |a - b| + u |p| + u |w| <= 3 u R + 2 u |p|.
// Upper bound, |v| of a simplex. Moving its vertices by err w moves |v| by no more. Computed from the rounded vertices:
//     a vertex: the length rounds by 2 u |w|; together at most 5 u S;
//     an edge e: its difference (or the turned local one, below 3.9 u |e| and for |e| <= S / 16 only), the sum of the
//     ends, two products and their difference give 3.5 u |w|; quotient and length of e 3 u |v|; together 9.5 u S.
// Lower bound, -h / |d| for a direction d that is exact by definition, h the largest height d . w. A height is
// dA . a + dB . b - d . p: turning d rounds by 2.42 u |d|, the dot product by 2 u |d| RA, and so for B; d . p and p by
// 3 u |d| |p|; two sums by u |d| R + u |h|; quotient and length of d by 3 u |h|:
//     5.42 u R + 3 u |p| + 4 u |v| <= 9.5 u S.
// Depth, the largest of all -h / |d| over the faces, each d an edge turned by 3.9 u at most. Against the exact face the
// lever of the turn is at most S: 13.4 u S. As a lower bound for that d, with the height of the edge's first end in
// place of the largest: the lever is 2 RA (A's edge), and |v| <= 2 min(RA, RB) where cores overlap, which gives
// 5.42 u R + 3 u |p| + 4 u |v| + 7.8 u RA <= 13.4 u S. A triangle said to contain the origin has it within 6 u S of its
// rounded vertices' hull (heights of its sides round by 3 u |w|, its tips' dot products by 2 u |w|): 9 u S. Small cores
// turn their vertices instead of the direction: a height d . a rounds by 3 u |d| RA, and so for B; their sum, d . p and
// p as above: 4 u R + 3 u |p| + 4 u |v| as a lower bound by a vertex. By a face of A the direction is its edge, turned
// by 3.9 u, and the height that of its first end: 7.8 u RA more, which is below 15.8 u S; as an upper bound its line's
// distance has the same lever, and a foot that rounding took inside lies at most 3 u S outside, where the distance is
// larger by (3 u S)^2 / (2 v): such answers are given for v > E only. The leading face of overlapping cores is chosen
// by rounded separations, 3 u |v| more with |v| <= 2 min(RA, RB): below 14 u S.
// All stay below 16 u S by more than the rounding of S itself and of the bounds.
#pragma once

#include "narrow/cores/core_pair.hpp"
#include "simd/lane_function.hpp"

namespace tumble {

inline constexpr double kUnitRoundoff = 0x1p-53;

// Of a scale, or of a scale a lane.
template <typename Number>
TUMBLE_LANE_FUNCTION Number error_bound(const Number& scale) {
    return 16.0 * kUnitRoundoff * scale;
}
inline double error_bound(const CorePair& pair) { return error_bound(pair.scale); }

// GJK stops where a new support is no nearer to the origin than the simplex by more than the support's own rounding.
template <typename Number>
TUMBLE_LANE_FUNCTION Number progress_bound(const Number& scale) {
    return 4.0 * kUnitRoundoff * scale;
}
inline double progress_bound(const CorePair& pair) { return progress_bound(pair.scale); }

}  // namespace tumble
