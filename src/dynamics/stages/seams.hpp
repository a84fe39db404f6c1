// Floors of several shapes, static or kinematic: the corner of one is not felt by what lies on another.
//
// Two shapes know nothing of a third. What slides over tiles sinks in by a hair and finds the next tile's side in its
// way: a ghost collision. A shape that lies on the plane of one ground cannot meet another that does not rise
// above this plane, except on the plane itself: its contact with another normal is dropped for the step. Chains need no
// such care, they know their neighbours; and of two faces that meet in a ridge both may carry, if they carry different
// shapes.
#pragma once

#include "dynamics/state/simulation.hpp"

namespace tumble {

// A stage of the step, between collision and the preparation of constraints. Tiles are shapes of at most eight vertices
// on bodies that are not dynamic; for each moving shape all pairs of those that it touches are looked at.
void smooth_seams(Simulation& simulation);

}  // namespace tumble
