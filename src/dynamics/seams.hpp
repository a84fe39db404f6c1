// Floors of several static shapes: the corner of one is not felt by what lies on another.
//
// Two shapes know nothing of a third. What slides over tiles sinks in by a hair and finds the next tile's side in its
// way: a ghost collision. A shape that lies on a plane with a static one cannot meet a static shape that does not rise
// above this plane, except on the plane itself: its contact with another normal is dropped for the step. Chains need no
// such care, they know their neighbours; and of two faces that meet in a ridge both may carry, if they carry different
// shapes.
#pragma once

#include "dynamics/simulation.hpp"

namespace tumble {

// A stage of the step, between collision and the preparation of constraints. Tiles are static shapes of at most eight vertices;
// for each moving shape all pairs of those that it touches are looked at.
void smooth_seams(Simulation& simulation);

}  // namespace tumble
