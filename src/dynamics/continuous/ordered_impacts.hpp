// Continuous collision: impacts happen at their time within the step, in the order of time, and the bodies go on from
// there.
//
// A body is swept if it moves by more than a part of its smallest extent (kContinuousPart), if one of its contacts
// bounces, or once another body hits it. The earliest impact is solved first, together with the contacts that pass it
// on (impacts/impact_group.hpp). The bodies that it changed have a new motion for the rest of the step, and new impacts
// ahead.
//
// The work is bounded: a body whose impacts in a step weigh kMaxImpactsPerBody stays where it is until the step ends,
// and keeps its velocity.
#pragma once

#include "dynamics/state/simulation.hpp"

namespace tumble {

// A stage of the step, before poses are final. Collects also the sensors near the paths of fast bodies.
void simulate_impacts(Simulation& simulation);

}  // namespace tumble
