// Everything that a world consists of.
//
// The soft-step solver [Catto 2024, "Solver2D"]: collision once a step, then several sub-steps of integrating, solving
// each constraint once with a soft bias and once without.
#pragma once

#include <cstdint>
#include <vector>

#include "broad/broad_phase.hpp"
#include "dynamics/bodies/body_store.hpp"
#include "dynamics/bodies/shape_store.hpp"
#include "dynamics/contacts/constraint_graph.hpp"
#include "dynamics/contacts/contact_block.hpp"
#include "dynamics/contacts/contact_store.hpp"
#include "dynamics/joints/joint_store.hpp"
#include "dynamics/state/island_finder.hpp"
#include "dynamics/state/sleeping_islands.hpp"
#include "tumble/cast.hpp"
#include "tumble/counters.hpp"
#include "tumble/events.hpp"

namespace tumble {

struct StepSettings {
    Vec2 gravity;
    float duration = 0.0f;  // of a step, s
    int substeps = 4;
    bool sleeping = true;
    bool continuous = true;
    Tuning tuning;

    float substep_duration() const { return duration / static_cast<float>(substeps); }
};

// A body that falls asleep, and the root of its island: its solver body when islands were found.
struct Sleeper {
    std::uint32_t body = 0;
    std::uint32_t root = 0;

    friend constexpr auto operator<=>(Sleeper, Sleeper) = default;
};

// Contacts with at least one manifold point after a step, awake and asleep.
struct ContactCounts {
    std::size_t contacts = 0;
    std::size_t points = 0;
};

// What the narrow phase did in a step before it was solved: pairs it was asked about, collisions in full, and the
// iterations of their distance queries.
struct CollisionCounts {
    std::int64_t asked = 0;
    std::int64_t full = 0;
    std::int64_t iterations = 0;
};

// A contact of a dynamic shape with one that is not and is no part of a chain.
struct GroundContact {
    std::uint32_t moving_shape = 0;
    std::uint32_t contact = 0;  // index

    friend constexpr auto operator<=>(GroundContact, GroundContact) = default;
};

// A body that moves fast enough in this step to be swept.
struct Mover {
    static constexpr std::size_t kNobody = static_cast<std::size_t>(-1);

    std::uint32_t body = 0;
    Sweep sweep;
    Aabb box;                       // of all that its shapes may cover
    double fraction = 1.0;          // of the step's motion that it makes
    double next = 1.0;              // of a bullet: the first meeting ahead, or `fraction`
    std::size_t partner = kNobody;  // whom it meets, if that is a mover
    ProxyPair meeting{};            // the shapes that stop it, if `fraction` is below 1
    ProxyPair next_meeting{};       // those that meet at `next`
    bool is_bullet = false;
};

// Whether any shape passes a one-sided chain.
struct ChainPasses {
    bool before = false;  // in the last step
    bool now = false;     // in this one, as far as pairs have been collided
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
    SleepingIslands sleeping;
    StepEvents events;  // of the last step
    ContactCounts contact_counts;
    CollisionCounts collided;
    ChainPasses passes;
    StageTimes times;
    bool filters_changed = false;  // by a joint, a filter, a type...: contacts may have to go that were allowed

    // Of the stage that puts islands to sleep; kept to be used again.
    IslandFinder islands;
    std::vector<Sleeper> sleepers;
    std::vector<std::uint32_t> island_of_root;  // by solver body
    std::vector<JointId> sleeping_joints;

    std::vector<float> given_work;        // of the stage that bounces, likewise: by solver body, J
    std::vector<GroundContact> footings;  // of the stage that smooths seams, likewise

    // Of continuous collision, likewise.
    std::vector<Mover> movers;
    std::vector<std::uint32_t> near_shapes;
    std::vector<ProxyPair> impacts;  // of this step: pairs whose shapes have met on the way, sorted
    std::vector<ProxyPair>
        sensor_passes;  // of this step: sensors near the way of a mover; in the end those that it met

    // False once one of the shapes is gone, for good or because its body is disabled.
    bool is_live(ProxyPair pair) const { return shapes[pair.a].is_placed && shapes[pair.b].is_placed; }
};

}  // namespace tumble
