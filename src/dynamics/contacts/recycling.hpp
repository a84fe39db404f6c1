// Contact recycling: a pair that has barely moved since its last full collision keeps the manifold, rotated and with
// new separations [Catto 2026, "Contact recycling"]. A pair that was apart stays without points until it has moved by
// as much as it was apart.
//
// The result follows from the manifold and poses of the last full collision, never from a recycled manifold, so that
// errors do not accumulate: they are those of features fixed on bodies that move by less than the tolerance.
#pragma once

#include "dynamics/bodies/body_store.hpp"
#include "tumble/manifold.hpp"

namespace tumble {

// The result of a full collision, and the poses at that time.
struct ManifoldReference {
    Manifold manifold;
    Rotation rotation_a, rotation_b;
    DVec2 offset;      // of B's origin from A's, world axes, m
    float gap = 0.0f;  // without points: by how much the distance exceeds the speculative distance, m
    bool is_valid = false;
};

// How two bodies have moved since the reference. The poses are those of the bodies' origins.
struct MotionSince {
    Rotation turn_a, turn_b;
    Vec2 shift;  // of B's origin relative to A's, world axes, m
};

inline MotionSince motion_since(const ManifoldReference& reference, const Pose& a, const Pose& b) {
    return {rotation_between(reference.rotation_a, a.rotation), rotation_between(reference.rotation_b, b.rotation),
            to_float(b.position - a.position - reference.offset)};
}

// How far a point of one shape has moved relative to the other, at most, m; infinite if the reference is not valid or
// they have turned by a quarter of a turn. A reach is the distance of a shape's farthest point from its body's origin,
// m.
float greatest_displacement(const ManifoldReference& reference, const MotionSince& motion, float reach_a,
                            float reach_b);

// Sets the manifold to that of the reference after the motion.
void recycle(Manifold& manifold, const ManifoldReference& reference, const MotionSince& motion);

}  // namespace tumble
