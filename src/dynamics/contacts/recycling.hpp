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

// How far a point of one shape has moved relative to the other since the reference, at most, m; infinite if the
// reference is not valid or they have turned by a quarter of a turn. The poses are those of the bodies' origins. A
// reach is the distance of a shape's farthest point from its body's origin, m.
float displacement_since(const ManifoldReference& reference, const Pose& a, const Pose& b, float reach_a,
                         float reach_b);

// The manifold of the reference at the present poses.
Manifold recycled(const ManifoldReference& reference, const Pose& a, const Pose& b);

}  // namespace tumble
