#include "dynamics/contacts/recycling.hpp"

#include <algorithm>
#include <cmath>

#include "debug/check.hpp"
#include "dynamics/bodies/solver_body.hpp"

namespace tumble {

namespace {

// The rotation from an old to a new orientation.
Rotation rotation_between(Rotation from, Rotation to) {
    return {to.c * from.c + to.s * from.s, to.s * from.c - to.c * from.s};
}

// (R(q) - 1) v without cancellation.
Vec2 displacement(Rotation q, Vec2 v) {
    const float c = q.c - 1.0f;
    return {c * v.x - q.s * v.y, q.s * v.x + c * v.y};
}

}  // namespace

bool recycle(const ManifoldReference& reference, const Pose& a, const Pose& b, float reach_a, float reach_b,
             float tolerance, Manifold& manifold) {
    if (!reference.is_valid) return false;
    TUMBLE_CHECK(reference.manifold.point_count <= 2);
    TUMBLE_CHECK(tolerance >= 0.0f);
    TUMBLE_CHECK(reach_a >= 0.0f);
    TUMBLE_CHECK(reach_b >= 0.0f);
    const Rotation turn_a = rotation_between(reference.rotation_a, a.rotation);
    const Rotation turn_b = rotation_between(reference.rotation_b, b.rotation);
    // In the frame of the body that reaches farther, the other's origin has moved by `relative_shift`, and its points
    // by the relative rotation.
    const DVec2 offset = b.position - a.position;
    const Vec2 shift = to_float(offset - reference.offset);
    const Rotation frame = reach_a >= reach_b ? turn_a : turn_b;
    const Vec2 relative_shift = shift - displacement(frame, to_float(reference.offset));
    const Rotation relative_turn = rotation_between(turn_a, turn_b);
    const float moved = length(relative_shift) + std::abs(relative_turn.s) * std::min(reach_a, reach_b);
    if (!(moved <= tolerance && relative_turn.c > 0.0f)) return false;

    manifold = reference.manifold;
    manifold.normal = rotate(turn_a, manifold.normal);
    for (int i = 0; i < manifold.point_count; ++i) {
        ManifoldPoint& point = manifold.points[i];
        const Vec2 change_a = displacement(turn_a, point.anchor_a), change_b = displacement(turn_b, point.anchor_b);
        point.separation += dot(shift + (change_b - change_a), manifold.normal);
        point.anchor_a += change_a;
        point.anchor_b += change_b;
    }
    return true;
}

}  // namespace tumble
