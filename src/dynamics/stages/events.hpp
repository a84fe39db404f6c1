// Notices what begins and ends, for the user's lists of events.
#pragma once

#include "dynamics/state/simulation.hpp"

namespace tumble {

// A stage of the step: compares whether pairs touch with whether they did. Sensors look where bodies are now.
// Counts contacts by the way.
void report_events(Simulation& simulation);

void clear(StepEvents& events);

// A contact is about to be dropped: it ends if it touched, and begins before if it came and went within the step.
void report_parting(Simulation& simulation, Contact& contact);

}  // namespace tumble
