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
// do, and of two kinds of inelastic ones. A body lands that carries others: the few sweeps of the solver would leave
// such a stack with overlap and approaches, from which it rebounds with half of its speed. Or the impact is so fast
// that the sub-steps are too long for it.
void find_bounces(Simulation& simulation);

}  // namespace tumble
