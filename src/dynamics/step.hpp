// One step of a simulation, as a list of named stages.
//
// The soft-step solver [Catto 2024, "Solver2D"]: collision once a step, then several sub-steps of integrating, solving
// each constraint once with a soft bias and once without.
#pragma once

#include <cstdint>

namespace tumble {

struct Simulation;

// Advances by one step, before which there were `earlier_steps`. Returns false if find_diverged() now finds a body that
// is not finite: the stages after the final poses were skipped, and the simulation cannot go on.
bool step(Simulation& simulation, std::uint64_t earlier_steps);

// Stages of step(), in order; those of collision.hpp, dynamics/stages and dynamics/continuous come between. README.md
// has the whole list.
void cover_free_motions(Simulation& simulation);
void prepare_constraints(Simulation& simulation);
void run_substeps(Simulation& simulation);
void bounce(Simulation& simulation);
void store_results(Simulation& simulation);
void forget_clamped_impulses(Simulation& simulation);
void collide_continuously(Simulation& simulation);
void update_proxies(Simulation& simulation);

}  // namespace tumble
