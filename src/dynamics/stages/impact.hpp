// When a shape must stop for another on its way through a step.
//
// Only what would pass deeply counts: the sweep of a shape's core, smaller than the shape, decides whether to stop, so
// that sliding over the seam of two floors is no impact; the sweep of the shape itself says when.
#pragma once

#include "dynamics/bodies/shape_store.hpp"
#include "tumble/cast.hpp"

namespace tumble {

// The fraction of the step, 1 if it may go all the way. Apart, a shape stops at the surface; it may sink in as far as
// its core if it touches already, or the solver held the two apart in this step. One whose core is in goes no deeper,
// up to its middle: 0.
double impact(const ShapeRecord& moving, const Sweep& sweep, const ShapeRecord& other, const Sweep& other_sweep,
              bool is_held);

}  // namespace tumble
