// When two moving shapes have their first impact.
#pragma once

#include "dynamics/bodies/shape_store.hpp"
#include "tumble/cast.hpp"

namespace tumble {

struct PairImpact {
    double fraction = 1.0;  // of the sweeps, 0 to 1; 1 if there is no impact
    DVec2 point;            // of an impact: where the shapes touch, world, m
    DVec2 normal;           // unit, from the other shape to the moving one
    bool touched = false;   // the shapes touched when the sweeps began
};

// The first impact of two shapes.
//
// A core of the moving shape, smaller by `inset` (m, 0 if both are segments) on each side, decides whether there is an
// impact: only then a shape can slide over the seam of two floors. The sweep of the whole shape decides when. Shapes
// that touch already, or were `pushed` apart by the solver in this step, have an impact only when the core touches. If
// the core overlaps already, the largest smaller core that does not takes its place. A shape that overlaps with its
// middle has no impact, nor has one that starts behind a one-sided segment.
PairImpact find_impact(const ShapeRecord& moving, const Sweep& sweep, const ShapeRecord& other,
                       const Sweep& other_sweep, float inset, bool pushed);

// The same for two shapes whose contact bounces: their surfaces decide, unless they overlap already.
PairImpact find_bounce(const ShapeRecord& moving, const Sweep& sweep, const ShapeRecord& other,
                       const Sweep& other_sweep, float inset);

// The fraction of the sweep that the moving shape may make, 0 to 1. A shape that is apart stops when the surfaces
// touch. A shape that touches already, or `was_pushed` apart by the solver in this step, may sink in as far as its
// core. A shape whose core overlaps already stops at once (0) if a smaller core would sink in; a shape that overlaps
// with its middle is left to the solver (1), as is one that starts behind a one-sided segment.
double find_stop(const ShapeRecord& moving, const Sweep& sweep, const ShapeRecord& other, const Sweep& other_sweep,
                 bool was_pushed);

}  // namespace tumble
