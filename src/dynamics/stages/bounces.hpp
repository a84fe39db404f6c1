// Contacts that bounce in this step. The solver leaves them to continuous collision, which reflects the bodies at the
// time of their impact.
#pragma once

#include "dynamics/state/simulation.hpp"

namespace tumble {

// The approach speed from which a contact of two bodies bounces, m/s: twice what their free acceleration along the
// normal gives in a step. Below it resting bodies would hop. Without gravity every impact bounces.
double bounce_threshold(const Simulation& simulation, std::uint32_t body_a, std::uint32_t body_b, Vec2 normal);

// A stage of the step, before constraints are prepared: marks the contacts that bounce.
void find_bounces(Simulation& simulation);

}  // namespace tumble
