// The last full collision, from which a manifold is recycled.
#pragma once

#include "tumble/manifold.hpp"
#include "tumble/math.hpp"

namespace tumble {

// The result of a full collision, and the poses of the bodies' origins at that time. Contacts of sensors use only the
// poses. A shape does not change while it lives, so that its reach stays right.
struct ManifoldReference {
    DVec2 offset;  // of B's origin from A's, world axes, m
    Manifold manifold;
    Rotation rotation_a, rotation_b;
    float reach_a = 0.0f;  // the distance of the shape's farthest point from its body's origin, m
    float reach_b = 0.0f;
    // How far the shapes may move relative to each other until the next full collision, m. Negative: the reference is
    // not valid, and the next collision is full.
    float tolerance = -1.0f;
    // Where sharp corners touch an edge: the sum of 4 if the edge is B's, and 1 for the first and 2 for the second
    // point if it is at an end of the edge, so that the corner is that of the edge's owner. -1 for other contacts and
    // without points. A float, as lanes gather it with the members above.
    float corners = -1.0f;
    float gap = 0.0f;  // without points: by how much the distance exceeds the speculative distance, m

    void invalidate() { tolerance = -1.0f; }
};

}  // namespace tumble
