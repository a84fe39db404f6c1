#include "reference/parity/cast_judge.hpp"

#include <algorithm>
#include <cmath>

namespace tumble::reference {

namespace {

using Real = brute::Real;

// What the long double arithmetic of the truth may itself be wrong by, in E: 2^-11 of it, with a margin.
constexpr Real kOwnError = 1.0L / 256;

// The bracket must hold the first contact; where the motion never goes clearly below the target it may be found or not.
CastVerdict judge_straight_bracket(const TrueMotion& truth, const CastResult& hit) {
    const Real slack = kOwnError * (hit.upper - hit.lower);
    const std::optional<Real> first = truth.first_contact();
    if (first && hit.lower - slack <= *first && *first <= hit.upper + slack) return CastVerdict::hit;
    return truth.stays_above(-4 * truth.error(), 0, 1) ? CastVerdict::graze : CastVerdict::bracket;
}

CastVerdict judge_miss(const TrueMotion& truth, Real floor, Real clear) {
    if (!truth.stays_above(floor, 0, 1)) return CastVerdict::missed;
    return truth.gap(0) >= clear && truth.stays_above(clear, 0, 1) ? CastVerdict::miss : CastVerdict::graze;
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

CastVerdict judge(const TrueMotion& truth, const CastResult& ours) {
    const Real error = truth.error(), own = kOwnError * error;
    switch (ours.status) {
        case CastStatus::invalid: return CastVerdict::refused;
        case CastStatus::overlapping: return truth.gap(0) < own ? CastVerdict::overlap : CastVerdict::false_hit;
        case CastStatus::miss: return judge_miss(truth, -4 * error, own);
        case CastStatus::hit: break;
    }
    if (!is_ordered(ours)) return CastVerdict::bracket;
    const Real lower = std::max(0.0, ours.lower), upper = ours.upper;
    if (!truth.stays_above(-4 * error, 0, lower)) return CastVerdict::missed;
    if (!(std::abs(truth.gap(ours.fraction)) <= 4 * error)) return CastVerdict::false_hit;
    if (truth.is_straight() && lower > 0) return judge_straight_bracket(truth, ours);
    if (truth.gap(upper) > own)  // nothing is passed: only a touch that goes no deeper may be answered so
        return truth.gap(std::min(upper, Real{1})) <= 4 * error ? CastVerdict::graze : CastVerdict::bracket;
    return lower == 0 || truth.stays_above(-own, 0, lower) ? CastVerdict::hit : CastVerdict::graze;
}

CastVerdict judge(const TrueMotion& truth, const B2Cast& box2d, double tolerance) {
    if (box2d.overlaps) return truth.gap(0) < tolerance ? CastVerdict::overlap : CastVerdict::false_hit;
    if (!box2d.hits && truth.gap(0) < tolerance) return CastVerdict::graze;  // it calls a start at the target a miss
    if (!box2d.hits) return judge_miss(truth, -tolerance, 0);
    if (box2d.fraction > 0.0 && !truth.stays_above(-tolerance, 0, box2d.fraction)) return CastVerdict::missed;
    return truth.gap(box2d.fraction) <= tolerance ? CastVerdict::hit : CastVerdict::false_hit;
}

}  // namespace tumble::reference
