// The judge of one answer about moving shapes.
#pragma once

#include "reference/box2d/b2_cast.hpp"
#include "reference/exact/true_motion.hpp"

namespace tumble::reference {

// `missed`: the gap falls below -4 E before the answer says so, or though it says never. `false_hit`: at the fraction
// the gap is above 4 E, or below -4 E. `bracket`: the gap does not pass 0 between lower and upper. `graze`: right
// within 4 E, where the exact motion would have been answered the other way.
enum class CastVerdict : std::uint8_t { hit, miss, overlap, graze, missed, false_hit, bracket, refused };
const char* to_string(CastVerdict verdict);
inline bool is_wrong(CastVerdict verdict) { return verdict >= CastVerdict::missed; }

CastVerdict judge(const TrueMotion& truth, const CastResult& ours);

// The same for Box2D, whose E is 4 eps S and its own tolerance; no bracket.
CastVerdict judge(const TrueMotion& truth, const B2Cast& box2d, double tolerance);

}  // namespace tumble::reference
