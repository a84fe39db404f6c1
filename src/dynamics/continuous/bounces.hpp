// Contacts that bounce in this step. The solver leaves them to continuous collision, which reflects the bodies at the
// time of their impact.
#pragma once

#include "dynamics/state/simulation.hpp"

namespace tumble {

// The approach speed from which a contact bounces, m/s: it leaves with more than twice the speed that gravity and
// forces add in a step. Below it resting bodies would hop. Without gravity every impact bounces. Of an inelastic
// contact: from which it takes part in the impacts of others.
double bounce_threshold(const Simulation& simulation, const Contact& contact);

// Marks a contact that has just collided if it may bounce, and returns that.
bool note_bounce(const Simulation& simulation, Contact& contact);

// A stage of the step, before constraints are prepared: of the contacts that may bounce, keeps the mark of those that
// do. An inelastic contact keeps it in two cases: a body that carries others lands, and the few sub-steps of the solver
// would leave the stack with overlap, from which it rebounds at half its speed; or the impact is too fast for a
// sub-step.
void find_bounces(Simulation& simulation);

}  // namespace tumble
