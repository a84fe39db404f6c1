// Everything that a world consists of: settings, the state that a snapshot contains, the scratch memory of a step, and
// the measurements of the last step.
#pragma once

#include <cstddef>
#include <cstdint>

#include "broad/broad_phase.hpp"
#include "dynamics/bodies/body_store.hpp"
#include "dynamics/bodies/shape_store.hpp"
#include "dynamics/bodies/speed_limits.hpp"
#include "dynamics/contacts/contact_store.hpp"
#include "dynamics/joint_store/joint_store.hpp"
#include "dynamics/state/scratch_pointer.hpp"
#include "dynamics/state/sleeping_islands.hpp"
#include "tasks/crew.hpp"
#include "tumble/counters.hpp"
#include "tumble/events.hpp"
#include "tumble/joint.hpp"
#include "tumble/world_def.hpp"

namespace tumble {

// Derived from the world's definition.
struct StepSettings {
    Vec2 gravity;
    float duration = 0.0f;  // of a step, s
    int substeps = 4;
    bool sleeping = true;
    bool continuous = true;
    JointSolver joints = JointSolver::iterative;
    ImpactModel impacts = ImpactModel::in_order;
    Tuning tuning;

    float substep_duration() const { return duration / static_cast<float>(substeps); }
    SpeedLimits speed_limits() const {
        return {tuning.max_speed, kMaxRotation / duration, kMaxFastRotation / substep_duration()};
    }
    bool orders_impacts() const { return impacts == ImpactModel::in_order; }
};

inline StepSettings make_settings(const WorldDef& def) {
    const float duration = 1.0f / def.steps_per_second;
    return {def.gravity,    duration,   def.substeps, def.sleeping,
            def.continuous, def.joints, def.impacts,  make_tuning(def.scale, def.gravity, duration)};
}

// After a search for islands at rest that found none, so many steps do not search. Where some bodies rest on others
// that move, a search in each step would take a twentieth of the time of bench/junkyard.
inline constexpr std::uint32_t kPauseAfterSearch = 3;

// All that decides the future of a world, and the events of its last step: what a snapshot contains.
//
// A plain aggregate, and the only list of these members. Snapshots and count_memory() find them through the compiler
// (world/aggregate.hpp): a member added here is saved and counted without another line.
struct SimulationState {
    BodyStore bodies;
    ShapeStore shapes;
    JointStore joints;
    BroadPhase broad;
    ContactStore contacts;
    SleepingIslands sleeping;
    StepEvents events;  // of the last step
    ContactCounts contact_counts;
    // A shape of each contact that is kept for a step, because it touched, although its boxes are apart: indices.
    std::vector<std::uint32_t> kept_shapes;
    ChainCrossings chain_crossings;
    std::uint32_t steps_to_island_search = 0;  // until it may begin: at most kPauseAfterSearch
    bool filters_changed = false;  // since the last step, by a joint, filter or type: contacts may have to end

    ChainContacts chain_contacts() const { return {bodies, shapes, contacts, chain_crossings}; }

    // Makes the next search end the contacts that were kept.
    void touch_kept() {
        for (const std::uint32_t shape : kept_shapes)
            if (broad.has(shape)) broad.touch(shape);
        kept_shapes.clear();
    }

    // False once one of the shapes is destroyed, or its body disabled.
    bool is_live(ProxyPair pair) const { return shapes[pair.a].is_placed && shapes[pair.b].is_placed; }
};

// Measurements of the last step. They do not influence the next one and are not saved.
struct StepReport {
    CollisionCounts collided;
    int colors = 0;  // of the contacts
    StageTimes times;
};

struct Simulation : SimulationState {
    StepSettings settings;
    ScratchPointer scratch;
    StepReport report;
    Crew crew;  // the threads that make a step
};

}  // namespace tumble
