#include "dynamics/stages/impact.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "debug/check.hpp"
#include "dynamics/bodies/constants.hpp"
#include "dynamics/stages/shape_core.hpp"
#include "tumble/chain_manifold.hpp"

namespace tumble {

double impact(const ShapeRecord& moving, const Sweep& sweep, const ShapeRecord& other, const Sweep& other_sweep,
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
