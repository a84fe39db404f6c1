// The time of impact of two discs that turn about their own centres: only their centres move, along straight lines, so
// the quadratic of a cast decides it.
#pragma once

#include <algorithm>
#include <optional>

#include "narrow/cast/cast_circle.hpp"
#include "narrow/cast/cast_result.hpp"
#include "narrow/impact/moving_cores.hpp"

namespace tumble {

inline bool is_centered_disc(const Shape& shape, const Sweep& sweep) {
    return shape.vertex_count() == 1 && shape.x()[0] == sweep.local_center.x && shape.y()[0] == sweep.local_center.y;
}

// None if the discs start nearer than 2 E to the target, where the sign of the closing rate decides, or if they are
// points that meet.
//
// As nothing turns, the path is known better than a Motion knows it. Of the unit roundoff, the path rounds by 11 times
// the separation (centres, unit heading, product, fraction), twice the displacements and 5 times the reach: below half
// of the motion's E, which has 16 times the scale and 8 times the reach.
inline std::optional<CastResult> find_disc_impact(const Motion& motion, double reach, double radius_a,
                                                  const Sweep& sweep_a) {
    const DVec2 separation = motion.separation();
    if (!(length(separation) - reach > 2.0 * motion.error())) return std::nullopt;
    const double error = 0.5 * motion.error();
    const CastPath path{motion.velocity(), length(motion.velocity()), reach, error};
    if (!(path.length >= kSmallestScale)) return missed(1);
    const CircleEntry circle = find_circle_entry(path, -separation);
    const double fraction = std::max(0.0, circle.lower / path.length);
    if (!circle.is_reached || !(fraction < 1.0)) return missed(1);
    const double upper = circle.is_certain ? std::clamp(circle.upper / path.length, fraction, 1.0) : 1.0;
    const double away = length(circle.from_center);
    if (!(away > 0.0)) return std::nullopt;
    const DVec2 normal = (1.0 / away) * circle.from_center;
    const DVec2 center = sweep_a.start + fraction * (sweep_a.end - sweep_a.start);
    return CastResult{CastStatus::hit, fraction, fraction, upper, center + radius_a * normal, normal, 1, false};
}

}  // namespace tumble
