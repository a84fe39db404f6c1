#include "dynamics/contacts/recycling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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

float displacement_since(const ManifoldReference& reference, const Pose& a, const Pose& b, float reach_a,
                         float reach_b) {
    constexpr float kUnknown = std::numeric_limits<float>::infinity();
    TUMBLE_CHECK(reach_a >= 0.0f);
    TUMBLE_CHECK(reach_b >= 0.0f);
    if (!reference.is_valid) return kUnknown;
    const Rotation turn_a = rotation_between(reference.rotation_a, a.rotation);
    const Rotation turn_b = rotation_between(reference.rotation_b, b.rotation);
    // In the frame of the body that reaches farther, the other's origin has moved by `relative_shift`, and its points
    // by the relative rotation t: along a chord 2 sin(t / 2) = sin(t) f, f = sqrt(2 / (1 + cos t)), which is convex in
    // cos t, so that it stays below its chord from 1 at cos t = 1 to sqrt(2) at 0.
    const Vec2 shift = to_float(b.position - a.position - reference.offset);
    const Rotation frame = reach_a >= reach_b ? turn_a : turn_b;
    const Vec2 relative_shift = shift - displacement(frame, to_float(reference.offset));
    const Rotation relative_turn = rotation_between(turn_a, turn_b);
    if (!(relative_turn.c > 0.0f)) return kUnknown;
    const float chord = std::abs(relative_turn.s) * (1.0f + 0.41422f * (1.0f - relative_turn.c));
    return length(relative_shift) + chord * std::min(reach_a, reach_b);
}

Manifold recycled(const ManifoldReference& reference, const Pose& a, const Pose& b) {
    Manifold manifold = reference.manifold;
    TUMBLE_CHECK(manifold.point_count <= 2);
    if (manifold.point_count == 0) return manifold;
    const Rotation turn_a = rotation_between(reference.rotation_a, a.rotation);
    const Rotation turn_b = rotation_between(reference.rotation_b, b.rotation);
    const Vec2 shift = to_float(b.position - a.position - reference.offset);
    manifold.normal = rotate(turn_a, manifold.normal);
    for (int i = 0; i < manifold.point_count; ++i) {
        ManifoldPoint& point = manifold.points[i];
        const Vec2 change_a = displacement(turn_a, point.anchor_a), change_b = displacement(turn_b, point.anchor_b);
        point.separation += dot(shift + (change_b - change_a), manifold.normal);
        point.anchor_a += change_a;
        point.anchor_b += change_b;
    }
    return manifold;
}

}  // namespace tumble
