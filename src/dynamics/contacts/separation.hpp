// How far apart the shapes of a contact are, now and when the step ends. The normal is that of its start.
#pragma once

#include <algorithm>

#include "dynamics/bodies/sweeps.hpp"
#include "dynamics/contacts/contact.hpp"

namespace tumble {

// The least separation of the points of a manifold, m; 0 if it has none.
inline float least_separation(const Manifold& manifold) {
    float least = 0.0f;
    for (int i = 0; i < manifold.point_count; ++i)
        least = i == 0 ? manifold.points[i].separation : std::min(least, manifold.points[i].separation);
    return least;
}

// The displacement of B's point against A's in the step, m.
inline Vec2 relative_shift(const Contact& contact, const ManifoldPoint& point, const BodyStore& bodies) {
    return shift_in_step(bodies, contact.body_b, point.anchor_b) -
           shift_in_step(bodies, contact.body_a, point.anchor_a);
}

// Of a point when the step ends, m; negative if the shapes overlap.
inline float separation_at_end(const Contact& contact, const ManifoldPoint& point, const BodyStore& bodies) {
    return point.separation + dot(relative_shift(contact, point, bodies), contact.manifold.normal);
}

}  // namespace tumble
