// Memory that the stages of a step work in. No result depends on what a step leaves in it, and no snapshot contains it.
// It is kept so that the next step need not allocate, nor colour the same contacts again.
#pragma once

#include <cstdint>
#include <vector>

#include "broad/pair_set.hpp"
#include "broad/tree.hpp"
#include "dynamics/bodies/body_store.hpp"
#include "dynamics/contacts/contact.hpp"
#include "dynamics/contacts/contact_solver.hpp"
#include "dynamics/direct/joint_system.hpp"
#include "dynamics/state/impact_scratch.hpp"
#include "dynamics/state/island_finder.hpp"
#include "tasks/chunk_lists.hpp"
#include "tumble/cast.hpp"
#include "tumble/id.hpp"

namespace tumble {

// A body that falls asleep, and the root of its island.
struct Sleeper {
    std::uint32_t body = 0;  // index
    std::uint32_t root = 0;  // solver body when the islands were found

    friend constexpr auto operator<=>(Sleeper, Sleeper) = default;
};

// A contact between a dynamic shape and a shape of a static or kinematic body.
struct GroundContact {
    std::uint32_t moving_shape = 0;  // index
    std::uint32_t contact = 0;       // index

    friend constexpr auto operator<=>(GroundContact, GroundContact) = default;
};

// A body that moves far in this step, with ImpactModel::at_step_end.
struct FastBody {
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    std::uint32_t body = 0;  // index
    Sweep sweep;
    Aabb box;                     // covers its shapes during the whole sweep, world
    double fraction = 1.0;        // of the sweep that the body makes
    double next = 1.0;            // of a bullet: the fraction of the first impact ahead, or `fraction`
    std::size_t partner = kNone;  // the other body of that impact, if it is a fast one: its index among them
    ProxyPair impact{};           // the shapes whose impact stops it, if `fraction` is below 1
    ProxyPair next_impact{};      // the shapes of the impact at `next`
    bool is_bullet = false;
};

// What the narrow phase did in the last step before the constraints were solved.
struct CollisionCounts {
    std::int64_t pairs = 0;       // of solid shapes, collided in full or recycled
    std::int64_t full = 0;        // of these, collided in full
    std::int64_t iterations = 0;  // of the distance queries of the full ones
    std::int64_t bounces = 0;     // contacts that may bounce in this step
    std::int64_t crossings = 0;   // contacts in ChainState::crossing

    CollisionCounts& operator+=(const CollisionCounts& other) {
        pairs += other.pairs;
        full += other.full;
        iterations += other.iterations;
        bounces += other.bounces;
        crossings += other.crossings;
        return *this;
    }
};

// What the collision of a chunk of contacts found. In cache lines of its own, as other threads write its neighbours.
struct alignas(64) CollidedChunk {
    CollisionCounts counts;
    std::vector<std::uint32_t> newcomers;  // contacts that left ChainState::apart
    std::vector<GroundContact> grounds;

    void clear() {
        counts = {};
        newcomers.clear();
        grounds.clear();
    }
    std::size_t bytes() const {
        return newcomers.capacity() * sizeof(std::uint32_t) + grounds.capacity() * sizeof(GroundContact);
    }
};

// Contacts with at least one manifold point after a step, awake and asleep.
struct ContactCounts {
    std::size_t contacts = 0;
    std::size_t points = 0;
};

// The velocity of a body before the step.
struct StartVelocity {
    DVec2 linear;          // m/s
    float angular = 0.0f;  // rad/s
};

// What the chunks of a stage find. The stages use it one after the other.
struct ChunkScratch {
    ChunkLists<std::uint32_t> found;          // indices of contacts
    std::vector<std::uint32_t> newcomers;     // of all chunks
    std::vector<std::uint32_t> woken_rounds;  // the first index of each round in ContactStore::woken()
    ChunkLists<BroadPhase::MovedProxy> moved_proxies;
    ChunkLists<ProxyPair> crossings;            // of sensors
    std::vector<CollidedChunk> collided;        // by chunk
    std::vector<ContactCounts> contact_counts;  // by chunk

    std::size_t bytes() const {
        std::size_t bytes = collided.capacity() * sizeof(CollidedChunk);
        for (const CollidedChunk& chunk : collided) bytes += chunk.bytes();
        return bytes + found.bytes() + (newcomers.capacity() + woken_rounds.capacity()) * sizeof(std::uint32_t) +
               moved_proxies.bytes() + crossings.bytes() + contact_counts.capacity() * sizeof(ContactCounts);
    }
};

// A plain aggregate: count_memory() finds its members through the compiler, so none can be left out.
struct StepScratch {
    ChunkScratch chunks;

    // Constraints.
    ContactSolver contact_solver;
    JointSystem joint_system;
    std::vector<GroundContact> ground_contacts;  // that had points when they collided

    // Falling asleep.
    IslandFinder islands;
    std::vector<Sleeper> sleepers;
    std::vector<std::uint32_t> island_of_root;  // by solver body
    std::vector<JointId> sleeping_joints;

    // Continuous collision.
    std::vector<FreeMotion> free_motions;    // by solver body, of those awake when the step began
    std::vector<FastBody> fast_bodies;       // by body index
    std::vector<std::uint32_t> near_shapes;  // indices
    // Pairs whose impact stopped a body in this step, sorted; if impacts are in order, those that had no contact.
    std::vector<ProxyPair> impacts;
    std::vector<StartVelocity> start_velocities;  // by solver body, if impacts are in order
    ImpactScratch ordered_impacts;
    std::vector<ProxyPair> sensor_crossings;  // candidates during the sweep, then those that were crossed, sorted
};

}  // namespace tumble
