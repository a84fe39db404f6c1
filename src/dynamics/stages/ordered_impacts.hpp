// Continuous collision: impacts happen at their time within the step, in the order of time, and the bodies go on from
// there.
//
// A body is swept if it moves by more than a part of its smallest extent (kContinuousPart), if one of its contacts
// bounces, or once another body hits it. At the first impact of all, the impact is solved together with the contacts
// through which it goes on (impacts/impact_group.hpp); the bodies that it changed have a new motion for the rest of the
// step, and new impacts ahead.
//
// The work is bounded: a body that has had kMaxImpactsPerBody impacts in a step rests where it is until the step ends,
// with the velocity that it has.
#pragma once

#include "dynamics/state/simulation.hpp"

namespace tumble {

// A stage of the step, before poses are final. Collects also the sensors near the paths of fast bodies.
void simulate_impacts(Simulation& simulation);

}  // namespace tumble
