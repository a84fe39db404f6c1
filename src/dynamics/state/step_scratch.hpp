// Memory that the stages of a step work in. Nothing in it outlives the step: it is kept only so that the next step need
// not allocate, and no snapshot contains it.
#pragma once

#include <cstdint>
#include <vector>

#include "broad/pair_set.hpp"
#include "dynamics/contacts/contact_solver.hpp"
#include "dynamics/state/island_finder.hpp"
#include "tumble/cast.hpp"
#include "tumble/id.hpp"

namespace tumble {

// A body that falls asleep, and the root of its island.
struct Sleeper {
    std::uint32_t body = 0;  // index
    std::uint32_t root = 0;  // solver body when the islands were found

    friend constexpr auto operator<=>(Sleeper, Sleeper) = default;
};

// A contact between a dynamic shape and a shape of a static or kinematic body that is not part of a chain.
struct GroundContact {
    std::uint32_t moving_shape = 0;  // index
    std::uint32_t contact = 0;       // index

    friend constexpr auto operator<=>(GroundContact, GroundContact) = default;
};

// A body that moves fast enough in this step to be swept.
struct Mover {
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    std::uint32_t body = 0;  // index
    Sweep sweep;
    Aabb box;                     // covers its shapes during the whole sweep, world
    double fraction = 1.0;        // of the sweep that the body makes
    double next = 1.0;            // of a bullet: the fraction of the first impact ahead, or `fraction`
    std::size_t partner = kNone;  // the other body of that impact, if it is a mover: its index among them
    ProxyPair impact{};           // the shapes whose impact stops it, if `fraction` is below 1
    ProxyPair next_impact{};      // the shapes of the impact at `next`
    bool is_bullet = false;
};

// A plain aggregate: count_memory() finds its members through the compiler, so none can be left out.
struct StepScratch {
    // Constraints.
    ContactSolver contact_solver;
    std::vector<GroundContact> ground_contacts;  // of seams

    // Falling asleep.
    IslandFinder islands;
    std::vector<Sleeper> sleepers;
    std::vector<std::uint32_t> island_of_root;  // by solver body
    std::vector<JointId> sleeping_joints;

    // Continuous collision.
    std::vector<Mover> movers;                // by body index
    std::vector<std::uint32_t> near_shapes;   // indices
    std::vector<ProxyPair> impacts;           // pairs whose impact stopped a body in this step, sorted
    std::vector<ProxyPair> sensor_crossings;  // candidates during the sweep, then those that were crossed, sorted
};

}  // namespace tumble
