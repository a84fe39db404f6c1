// The fraction of a step at which a moving shape must stop at another.
//
// The core of the moving shape, smaller than the shape, decides whether it stops: only then sliding over the seam of
// two floors is not an impact. The sweep of the whole shape decides when.
#pragma once

#include "dynamics/bodies/shape_store.hpp"
#include "tumble/cast.hpp"

namespace tumble {

// The fraction of the sweep that the moving shape may make, 0 to 1. A shape that is apart stops when the surfaces
// touch. A shape that touches already, or `was_pushed` apart by the solver in this step, may sink in as far as its
// core. A shape whose core overlaps already stops at once (0) if a smaller core would sink in; a shape that overlaps
// with its middle is left to the solver (1), as is one that starts behind a one-sided segment.
double impact(const ShapeRecord& moving, const Sweep& sweep, const ShapeRecord& other, const Sweep& other_sweep,
              bool was_pushed);

}  // namespace tumble
