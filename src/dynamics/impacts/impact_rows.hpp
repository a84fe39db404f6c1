// How the points of a group approach, and the rows of a round: the directions in which points push, with what a pass
// needs of their bodies.
#pragma once

#include <cstddef>
#include <vector>

#include "dynamics/impacts/impact_group.hpp"

namespace tumble {

// The normal velocity of B's point against A's, with the changes so far, m/s: negative if they approach. At the impact,
// and of the motion ahead.
double approach_at_impact(const ImpactGroup& group, const ImpactPoint& point);
double approach_ahead(const ImpactGroup& group, const ImpactPoint& point);

// The velocity of B's point against A's along an axis, of two bodies that move so, m/s. `across` is arm x axis, m.
inline double speed_along(DVec2 axis, double across_a, double across_b, const Twist& a, const Twist& b) {
    return dot(b.linear - a.linear, axis) + b.angular * across_b - a.angular * across_a;
}
inline double speed_along(const ImpactDirection& d, const Twist& a, const Twist& b) {
    return speed_along(d.axis, d.across_a, d.across_b, a, b);
}

// True if the point has a restitution, and has bounced in fewer than kMaxBounces rounds.
bool can_bounce(const ImpactPoint& point);

// A point of the group at the impact, after the rounds so far.
ImpactRow make_row(const ImpactGroup& group, std::size_t index);

// The same point in the motion ahead, after all impacts, without friction.
ImpactRow make_hold_row(const ImpactGroup& group, std::size_t index);

// Marks pairs of rows that are the two points of one contact.
void pair_up(std::vector<ImpactRow>& rows, const std::vector<ImpactPoint>& points);

}  // namespace tumble
