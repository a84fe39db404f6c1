// Clipping: the edge of one core that faces a reference edge of the other, cut to the reference edge's length.
#pragma once

#include "narrow/cores/support.hpp"
#include "tumble/manifold.hpp"

namespace tumble {

// The core that owns the reference edge and the incident core, both relative to the owner's position.
struct ClipInput {
    const Core& reference;
    const Core& incident;
    DVec2 shift;       // from the reference's position to the incident's
    int edge;          // of the reference, by its first vertex
    int nearest;       // the incident core's vertex nearest to the reference edge's line; -1 if it is not known
    DVec2 normal;      // of the reference edge, unit; set if `nearest` is known
    double tolerance;  // the nearest vertex is not cut off if that would raise the separation by more (m)
};

struct ClippedPoint {
    DVec2 position;           // on the incident core, relative to the reference's position
    double separation = 0.0;  // of the cores along the normal
    int reference_vertex = 0;
    int incident_vertex = 0;
};

// In the counter-clockwise order of the reference edge; at least one point.
struct ClippedEdge {
    DVec2 normal;  // unit, out of the reference
    ClippedPoint points[2];
    int count = 0;
};

ClippedEdge clip(const ClipInput& input);

}  // namespace tumble
