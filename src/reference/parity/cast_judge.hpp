// Judges an answer about moving shapes by the oracle.
#pragma once

#include "reference/box2d/b2_cast.hpp"
#include "reference/exact/motion_oracle.hpp"

namespace tumble::reference {

// `missed`: the gap falls below -4 E before the reported fraction, or although a miss is reported. `false_hit`: the
// absolute gap at the fraction is above 4 E, or an overlap is reported for a positive gap. `bracket`: the gap does not
// reach 0 between lower and upper, or the numbers of the hit are inconsistent. `graze`: right within 4 E, although the
// exact answer is the opposite. `refused`: the status is `invalid`. `missed` and all verdicts after it are wrong.
enum class CastVerdict : std::uint8_t { hit, miss, overlap, graze, missed, false_hit, bracket, refused };
const char* to_string(CastVerdict verdict);
inline bool is_wrong(CastVerdict verdict) { return verdict >= CastVerdict::missed; }

CastVerdict judge(const MotionOracle& oracle, const CastResult& ours);

// The same for Box2D with `tolerance` (m) in place of 4 E, and without a bracket.
CastVerdict judge(const MotionOracle& oracle, const B2Cast& box2d, double tolerance);

}  // namespace tumble::reference
