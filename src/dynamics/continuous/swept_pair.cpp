#include "dynamics/continuous/swept_pair.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "debug/check.hpp"
#include "dynamics/bodies/constants.hpp"
#include "dynamics/continuous/shape_core.hpp"
#include "tumble/manifold.hpp"

namespace tumble {

namespace {

// The part of its thickness that a shape keeps if it shrinks by `inset` on each side.
float core_part(const ShapeRecord& record, float inset) {
    const float least = kContinuousCores[0];
    if (!(record.smaller_extent > 0.0f)) return least;
    return std::max(least, 1.0f - 2.0f * inset / record.smaller_extent);
}

PairImpact impact_of(const CastResult& hit, bool touched) { return {hit.fraction, hit.point, hit.normal, touched}; }

}  // namespace

PairImpact find_impact(const ShapeRecord& moving, const Sweep& sweep, const ShapeRecord& other,
                       const Sweep& other_sweep, float inset, bool pushed) {
    TUMBLE_CHECK(inset >= 0.0f);
    if (other.link && is_behind(other.shape, *other.link, pose_at(other_sweep, 0.0), moving.shape, pose_at(sweep, 0.0)))
        return {};
    const CastResult surface = time_of_impact(other.shape, other_sweep, moving.shape, sweep);
    if (surface.status == CastStatus::miss) return {};
    CastResult core = time_of_impact(other.shape, other_sweep, core_of(moving, core_part(moving, inset)), sweep);
    if (core.status == CastStatus::hit && !pushed && surface.status == CastStatus::hit && surface.fraction > 0.0)
        return impact_of(surface, false);
    for (const float part : kContinuousCores) {
        if (core.status != CastStatus::overlapping) break;
        core = time_of_impact(other.shape, other_sweep, core_of(moving, part), sweep);
    }
    return core.status == CastStatus::hit ? impact_of(core, true) : PairImpact{};
}

PairImpact find_bounce(const ShapeRecord& moving, const Sweep& sweep, const ShapeRecord& other,
                       const Sweep& other_sweep, float inset) {
    const CastResult surface = time_of_impact(other.shape, other_sweep, moving.shape, sweep);
    if (surface.status == CastStatus::hit) return impact_of(surface, false);
    if (surface.status == CastStatus::overlapping) return find_impact(moving, sweep, other, other_sweep, inset, false);
    return {};
}

double find_stop(const ShapeRecord& moving, const Sweep& sweep, const ShapeRecord& other, const Sweep& other_sweep,
                 bool was_pushed) {
    if (other.link && is_behind(other.shape, *other.link, pose_at(other_sweep, 0.0), moving.shape, pose_at(sweep, 0.0)))
        return 1.0;
    for (const float part : kContinuousCores) {
        const CastResult core = time_of_impact(other.shape, other_sweep, core_of(moving, part), sweep);
        if (core.status == CastStatus::overlapping) continue;
        if (core.status != CastStatus::hit) return 1.0;
        if (part < kContinuousCores[0]) return 0.0;
        if (was_pushed) return core.fraction;
        const CastResult surface = time_of_impact(other.shape, other_sweep, moving.shape, sweep);
        const bool touched = surface.status != CastStatus::hit || surface.fraction <= 0.0;
        return touched ? core.fraction : surface.fraction;
    }
    return 1.0;
}

}  // namespace tumble
