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

// Number by number: a manifold that is made elsewhere and copied as a whole waits for its parts, and takes 13 % more
// of the time to collide a pile at rest.
void recycle(Manifold& manifold, const ManifoldReference& reference, const MotionSince& motion) {
    const Manifold& from = reference.manifold;
    TUMBLE_CHECK(from.point_count <= 2);
    const Vec2 normal = from.point_count > 0 ? rotate(motion.turn_a, from.normal) : from.normal;
    manifold.normal.x = normal.x;
    manifold.normal.y = normal.y;
    manifold.point_count = from.point_count;
    for (int i = 0; i < from.point_count; ++i) {
        const ManifoldPoint& point = from.points[i];
        const Vec2 change_a = displacement(motion.turn_a, point.anchor_a);
        const Vec2 change_b = displacement(motion.turn_b, point.anchor_b);
        ManifoldPoint& moved = manifold.points[i];
        moved.anchor_a.x = point.anchor_a.x + change_a.x;
        moved.anchor_a.y = point.anchor_a.y + change_a.y;
        moved.anchor_b.x = point.anchor_b.x + change_b.x;
        moved.anchor_b.y = point.anchor_b.y + change_b.y;
        moved.separation = point.separation + dot(motion.shift + (change_b - change_a), normal);
        moved.feature = point.feature;
    }
    for (int i = from.point_count; i < 2; ++i) manifold.points[i] = from.points[i];
}

}  // namespace tumble
