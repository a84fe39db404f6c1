// Contact recycling: a pair that has barely moved since its last full collision keeps the manifold, rotated and with
// new separations [Catto 2026, "Contact recycling"].
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
    DVec2 offset;  // of B's origin from A's, world axes, m
    bool is_valid = false;
};

// Sets `manifold` to that of the two bodies at their present poses `a` and `b` (of their origins), and returns true, if
// no point of one shape has moved relative to the other by more than `tolerance` (m). Otherwise, or if the reference is
// not valid, returns false and leaves it. A reach is the distance of a shape's farthest point from its body's origin,
// m.
bool recycle(const ManifoldReference& reference, const Pose& a, const Pose& b, float reach_a, float reach_b,
             float tolerance, Manifold& manifold);

}  // namespace tumble
