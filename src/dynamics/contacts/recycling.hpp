// Contact recycling: a pair that has barely moved since its last full collision keeps the manifold, turned and with
// new separations [Catto 2026, "Contact recycling"].
//
// Everything is derived from the manifold and poses of the last full collision, never from the last step's result, so
// that errors cannot pile up: they are those of features fixed on bodies that move by less than the tolerance.
#pragma once

#include "dynamics/bodies/body_store.hpp"
#include "tumble/manifold.hpp"

namespace tumble {

// What a full collision found, and where the bodies were.
struct ManifoldReference {
    Manifold manifold;
    Rotation rotation_a, rotation_b;
    DVec2 offset;  // of B's origin from A's, world axes
    bool is_valid = false;
};

// The manifold of two bodies now, if no point of the pair has moved against the other by more than `tolerance` (m);
// false otherwise. `reach` is the distance of a shape's farthest point from its body's origin.
bool recycle(const ManifoldReference& reference, const Pose& a, const Pose& b, float reach_a, float reach_b,
             float tolerance, Manifold& manifold);

}  // namespace tumble
