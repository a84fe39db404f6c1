#include "reference/parity/cast_judge.hpp"

#include <algorithm>
#include <cmath>

namespace tumble::reference {

namespace {

using Real = brute::Real;

// The error of the oracle's long double arithmetic in units of E: 2^-11, with a margin.
constexpr Real kOracleError = 1.0L / 256;

// The bracket must contain the first contact. If the gap never falls clearly below 0, a hit and a miss are both right.
CastVerdict judge_straight_bracket(const MotionOracle& oracle, const CastResult& hit) {
    const Real slack = kOracleError * (hit.upper - hit.lower);
    const std::optional<Real> first = oracle.first_contact();
    if (first && hit.lower - slack <= *first && *first <= hit.upper + slack) return CastVerdict::hit;
    return oracle.stays_above(-4 * oracle.error(), 0, 1) ? CastVerdict::graze : CastVerdict::bracket;
}

CastVerdict judge_miss(const MotionOracle& oracle, Real floor, Real clear) {
    if (!oracle.stays_above(floor, 0, 1)) return CastVerdict::missed;
    return oracle.gap(0) >= clear && oracle.stays_above(clear, 0, 1) ? CastVerdict::miss : CastVerdict::graze;
}

bool is_ordered(const CastResult& hit) {
    return hit.lower <= hit.fraction && hit.fraction <= hit.upper && 0.0 <= hit.fraction && hit.fraction <= 1.0 &&
           std::abs(length(hit.normal) - 1.0) < 1e-15;
}

}  // namespace

const char* to_string(CastVerdict verdict) {
    switch (verdict) {
        case CastVerdict::hit: return "hit";
        case CastVerdict::miss: return "miss";
        case CastVerdict::overlap: return "overlap";
        case CastVerdict::graze: return "graze";
        case CastVerdict::missed: return "a missed hit";
        case CastVerdict::false_hit: return "a false hit";
        case CastVerdict::bracket: return "the bracket";
        case CastVerdict::refused: return "no answer";
    }
    return "unknown";
}

CastVerdict judge(const MotionOracle& oracle, const CastResult& ours) {
    const Real error = oracle.error(), slack = kOracleError * error;
    switch (ours.status) {
        case CastStatus::invalid: return CastVerdict::refused;
        case CastStatus::overlapping: return oracle.gap(0) < slack ? CastVerdict::overlap : CastVerdict::false_hit;
        case CastStatus::miss: return judge_miss(oracle, -4 * error, slack);
        case CastStatus::hit: break;
    }
    if (!is_ordered(ours)) return CastVerdict::bracket;
    const Real lower = std::max(0.0, ours.lower), upper = ours.upper;
    if (!oracle.stays_above(-4 * error, 0, lower)) return CastVerdict::missed;
    if (!(std::abs(oracle.gap(ours.fraction)) <= 4 * error)) return CastVerdict::false_hit;
    if (oracle.is_straight() && lower > 0) return judge_straight_bracket(oracle, ours);
    if (oracle.gap(upper) > slack)  // the gap does not reach 0 in the bracket: right only for a touch without overlap
        return oracle.gap(std::min(upper, Real{1})) <= 4 * error ? CastVerdict::graze : CastVerdict::bracket;
    return lower == 0 || oracle.stays_above(-slack, 0, lower) ? CastVerdict::hit : CastVerdict::graze;
}

CastVerdict judge(const MotionOracle& oracle, const B2Cast& box2d, double tolerance) {
    if (box2d.overlaps) return oracle.gap(0) < tolerance ? CastVerdict::overlap : CastVerdict::false_hit;
    if (!box2d.hits && oracle.gap(0) < tolerance)
        return CastVerdict::graze;  // Box2D reports a miss for a start at the target
    if (!box2d.hits) return judge_miss(oracle, -tolerance, 0);
    if (box2d.fraction > 0.0 && !oracle.stays_above(-tolerance, 0, box2d.fraction)) return CastVerdict::missed;
    return oracle.gap(box2d.fraction) <= tolerance ? CastVerdict::hit : CastVerdict::false_hit;
}

}  // namespace tumble::reference
