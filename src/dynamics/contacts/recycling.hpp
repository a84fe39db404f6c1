// Contact recycling: a pair that has barely moved since its last full collision keeps the manifold, rotated and with
// new separations [Catto 2026, "Contact recycling"]. A pair that was apart stays without points until it has moved by
// as much as it was apart.
//
// The result follows from the manifold and poses of the last full collision, never from a recycled manifold, so that
// errors do not accumulate: they are those of features fixed on bodies that move by less than the tolerance. For a
// sharp corner on an edge the recycled manifold is that of a full collision, as long as the same corner is on the edge;
// at the end of a reference edge it differs by the displacement times the angle between the edges.
#pragma once

#include <span>

#include "dynamics/bodies/body_store.hpp"
#include "simd/lane_count.hpp"

namespace tumble {

struct Contact;

// By the index of each contact.
struct Recycling {
    unsigned recycled = 0;  // a bit for each contact that has a recycled manifold now
    // How far a point of one shape has moved relative to the other since the reference, at most, m; infinite if they
    // have turned by a quarter of a turn. Without meaning if the reference is not valid.
    float moved[kLaneCount];
};

// How far the shapes of a contact may move relative to each other until the next full collision, m, by its reference.
// `smaller_extent` is that of the shapes, m.
float recycling_tolerance(const Contact& contact, float smaller_extent);

// Recycles the manifolds of those of up to eight contacts (at least one) whose shapes have moved by no more than their
// tolerance. The other contacts stay as they are.
Recycling recycle(std::span<Contact* const> contacts, const BodyStore& bodies);

}  // namespace tumble
