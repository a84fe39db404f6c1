#include "dynamics/contacts/recycling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "debug/check.hpp"
#include "dynamics/bodies/solver_body.hpp"

namespace tumble {

namespace {

// (R(q) - 1) v without cancellation.
Vec2 displacement(Rotation q, Vec2 v) {
    const float c = q.c - 1.0f;
    return {c * v.x - q.s * v.y, q.s * v.x + c * v.y};
}

}  // namespace

float greatest_displacement(const ManifoldReference& reference, const MotionSince& motion, float reach_a,
                            float reach_b) {
    constexpr float kUnknown = std::numeric_limits<float>::infinity();
    TUMBLE_CHECK(reach_a >= 0.0f);
    TUMBLE_CHECK(reach_b >= 0.0f);
    if (!reference.is_valid) return kUnknown;
    // In the frame of the body that reaches farther, the other's origin has moved by `relative_shift`, and its points
    // by the relative rotation t: along a chord 2 sin(t / 2) = sin(t) f, f = sqrt(2 / (1 + cos t)), which is convex in
    // cos t, so that it stays below its chord from 1 at cos t = 1 to sqrt(2) at 0.
    const Rotation frame = reach_a >= reach_b ? motion.turn_a : motion.turn_b;
    const Vec2 relative_shift = motion.shift - displacement(frame, to_float(reference.offset));
    const Rotation relative_turn = rotation_between(motion.turn_a, motion.turn_b);
    if (!(relative_turn.c > 0.0f)) return kUnknown;
    const float chord = std::abs(relative_turn.s) * (1.0f + 0.41422f * (1.0f - relative_turn.c));
    return length(relative_shift) + chord * std::min(reach_a, reach_b);
}

Manifold recycled(const ManifoldReference& reference, const MotionSince& motion) {
    Manifold manifold = reference.manifold;
    TUMBLE_CHECK(manifold.point_count <= 2);
    if (manifold.point_count == 0) return manifold;
    manifold.normal = rotate(motion.turn_a, manifold.normal);
    for (int i = 0; i < manifold.point_count; ++i) {
        ManifoldPoint& point = manifold.points[i];
        const Vec2 change_a = displacement(motion.turn_a, point.anchor_a);
        const Vec2 change_b = displacement(motion.turn_b, point.anchor_b);
        point.separation += dot(motion.shift + (change_b - change_a), manifold.normal);
        point.anchor_a += change_a;
        point.anchor_b += change_b;
    }
    return manifold;
}

}  // namespace tumble
