// Finds out which contacts began and ended in a step, for the user's lists of events.
#pragma once

#include "dynamics/state/simulation.hpp"

namespace tumble {

// A stage of the step, at the final poses: updates sensors, reports hits and the pairs that began or ceased to touch,
// and counts contacts.
void report_events(Simulation& simulation);

// A stage of the step, after impacts in order: gives contacts the impulses and approaches of their impacts.
void show_impacts(Simulation& simulation);

void clear(StepEvents& events);

// Reports the events of a contact before it is removed: its end if it touched, and its beginning too if it began within
// the step.
void report_removal(Simulation& simulation, Contact& contact);

}  // namespace tumble
