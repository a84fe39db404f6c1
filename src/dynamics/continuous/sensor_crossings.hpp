// Sensors that a fast body crosses within a step: it overlaps them neither before the step nor after it.
//
// The candidates are the sensors near the path of a body that continuous collision sweeps. A body crosses a sensor if
// the two touch during their motions of the step, which impacts may have shortened. Crossings of two fast bodies are
// left out if neither was near the other's path at the start of the step.
#pragma once

#include "dynamics/state/simulation.hpp"

namespace tumble {

// A stage of the step, after impacts and before poses are final: keeps those candidates that touch during the step and
// did not touch before it.
void find_sensor_crossings(Simulation& simulation);

}  // namespace tumble
