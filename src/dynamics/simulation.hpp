// Everything that a world consists of, and the step as a list of named stages.
//
// The soft-step solver [Catto 2024, "Solver2D"]: collision once a step, then several sub-steps of integrating, solving
// each constraint once with a soft bias and once without.
#pragma once

#include <cstdint>
#include <vector>

#include "broad/broad_phase.hpp"
#include "dynamics/body_store.hpp"
#include "dynamics/constraint_graph.hpp"
#include "dynamics/contact_block.hpp"
#include "dynamics/contact_store.hpp"
#include "dynamics/joint_store.hpp"
#include "dynamics/shape_store.hpp"

namespace tumble {

struct StepSettings {
    Vec2 gravity;
    float duration = 0.0f;  // of a step, s
    int substeps = 4;
};

// Wall clock of the last step's parts.
struct StepTimes {
    double pairs_ms = 0.0;
    double narrow_ms = 0.0;
    double solve_ms = 0.0;
    double total_ms = 0.0;
};

struct Simulation {
    StepSettings settings;
    BodyStore bodies;
    ShapeStore shapes;
    JointStore joints;
    BroadPhase broad;
    ContactStore contacts;
    ConstraintGraph graph;
    std::vector<ContactBlock> blocks;  // of the last step
    StepTimes times;
    bool filters_changed = false;  // a joint was created: contacts may have to go that were allowed
};

// One step. Afterwards find_diverged() tells whether its result is finite; the broad phase follows only if it is.
void step(Simulation& simulation);

// True if the two shapes may touch: one of them is dynamic, and no joint between their bodies forbids it.
bool may_collide(const Simulation& simulation, ProxyPair shapes);

// The stages, in order.
void find_pairs(Simulation& simulation);
void collide_pairs(Simulation& simulation);
void prepare_constraints(Simulation& simulation);
void run_substep(Simulation& simulation);
void bounce(Simulation& simulation);
void store_results(Simulation& simulation);
void update_proxies(Simulation& simulation);

}  // namespace tumble
