// Sensors that a fast body passes within a step: it is in them neither before nor after, and would not be noticed.
//
// Who is swept by continuous collision has the sensors near its way among the candidates; both go their ways of the
// step, stops included, and pass if they meet. Left out: two fast bodies of which neither was near the other's way
// before.
#pragma once

#include "dynamics/state/simulation.hpp"

namespace tumble {

// A stage of the step, once the motion is what it will be and before the poses are: keeps of the candidates those that
// meet on the way and did not touch before.
void find_sensor_crossings(Simulation& simulation);

}  // namespace tumble
