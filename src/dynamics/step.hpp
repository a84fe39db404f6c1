// One step of a simulation, as a list of named stages.
//
// The soft-step solver [Catto 2024, "Solver2D"]: collision once a step, then several sub-steps of integrating, solving
// each constraint once with a soft bias and once without.
#pragma once

namespace tumble {

struct Simulation;

// One step. Afterwards find_diverged() tells whether its result is finite; the broad phase follows only if it is.
void step(Simulation& simulation);

// The stages, in order.
void find_pairs(Simulation& simulation);
void collide_pairs(Simulation& simulation);
void collide_woken(Simulation& simulation);
void prepare_constraints(Simulation& simulation);
void run_substep(Simulation& simulation);
void bounce(Simulation& simulation);
void store_results(Simulation& simulation);
void forget_clamped_impulses(Simulation& simulation);
void update_proxies(Simulation& simulation);

}  // namespace tumble
