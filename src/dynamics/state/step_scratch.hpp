// Memory that the stages of a step work in. Nothing in it outlives the step: it is kept only so that the next step need
// not allocate, and no snapshot contains it.
#pragma once

#include <cstdint>
#include <vector>

#include "broad/pair_set.hpp"
#include "broad/tree.hpp"
#include "dynamics/bodies/body_store.hpp"
#include "dynamics/contacts/contact.hpp"
#include "dynamics/contacts/contact_solver.hpp"
#include "dynamics/direct/joint_system.hpp"
#include "dynamics/impacts/impact_group.hpp"
#include "dynamics/impacts/swept_body.hpp"
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

// A shape that has left its box in the broad phase.
struct MovedBox {
    std::uint32_t shape = 0;  // index
    Aabb box;                 // the new one, world
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

// In place of the index of a swept body.
inline constexpr std::uint32_t kNotSwept = 0xffffffffu;

// The first impact ahead of a swept body.
struct NextImpact {
    double time = 1.0;          // fraction of the step; 1 if there is none
    ProxyPair shapes{};         // whose impact it is
    DVec2 point;                // where they touch, world, m
    DVec2 normal;               // unit, from the first shape of the pair to the second; zero if not known
    int partner_impacts = 0;    // how many the other body had had
    std::uint32_t version = 0;  // counts the searches: an entry of the queue with another version is out of date
};

struct QueuedImpact {
    double time = 0.0;
    ProxyPair shapes{};
    std::uint32_t swept = 0;  // index among the swept bodies
    std::uint32_t version = 0;

    friend constexpr auto operator<=>(const QueuedImpact&, const QueuedImpact&) = default;
};

// An impact that has happened in this step, for events and for what contacts report.
struct Impact {
    ProxyPair shapes{};
    Approach approach;
    Manifold manifold;  // of the points that took part
    PointImpulse applied[2];
    int previous_of_a = -1, previous_of_b = -1;  // the impact before this one of the body of each shape; -1 for none
    bool is_reported = false;
};

// Where a point of an impact group comes from.
struct GroupPoint {
    ProxyPair shapes{};
    int manifold_point = 0;  // index in the manifold of the impact, or of the contact
    int impact = -1;         // index; -1 if the contact has taken part
};

// A contact through which a body lands that carries others.
struct Landing {
    double speed = 0.0;         // m/s
    std::uint32_t contact = 0;  // index

    friend constexpr auto operator<=>(const Landing&, const Landing&) = default;
};

// What decides which contacts bounce.
struct BounceScratch {
    bool has_candidates = false;              // some contact is marked as one that may bounce
    std::vector<std::uint32_t> touch_counts;  // by solver body: its contacts that have points
    std::vector<Landing> landings;
};

// A contact in the list of one of its bodies.
struct BodyContact {
    ProxyPair shapes{};
    std::uint32_t index = 0;
};

struct ContactLists {
    std::vector<std::uint32_t> first;  // by solver body: its range in `contacts`; empty if there are no lists yet
    std::vector<BodyContact> contacts;
};

// What continuous collision works on.
struct ImpactScratch {
    std::vector<SweptBody> swept;
    std::vector<NextImpact> next;            // by swept body
    std::vector<AabbTree::Node> leaves;      // by swept body, in the tree
    std::vector<std::uint32_t> swept_of;     // by solver body: index of a swept body, or kNotSwept
    AabbTree tree;                           // boxes of the motions ahead
    std::vector<QueuedImpact> queue;         // a heap, the earliest on top
    std::vector<std::uint32_t> near_shapes;  // indices
    ImpactGroup group;
    std::vector<std::uint32_t> members;  // by body of the group: index of a swept body, or kNotSwept
    std::vector<SinCos> member_turns;    // by body of the group: how far it has turned since the step began
    std::vector<GroupPoint> group_points;
    ContactLists contact_lists;
    BounceScratch bounces;
    std::vector<Impact> impacts;
};

// What the chunks of a stage find. The stages use it one after the other.
struct ChunkScratch {
    ChunkLists<std::uint32_t> found;       // indices of contacts
    std::vector<std::uint32_t> newcomers;  // contacts that left ChainState::apart
    ChunkLists<MovedBox> moved_boxes;
    ChunkLists<GroundContact> ground_contacts;
    std::vector<CollisionCounts> collision_counts;  // by chunk
    std::vector<ContactCounts> contact_counts;      // by chunk

    std::size_t bytes() const {
        return found.bytes() + newcomers.capacity() * sizeof(std::uint32_t) + moved_boxes.bytes() +
               ground_contacts.bytes() + collision_counts.capacity() * sizeof(CollisionCounts) +
               contact_counts.capacity() * sizeof(ContactCounts);
    }
};

// A plain aggregate: count_memory() finds its members through the compiler, so none can be left out.
struct StepScratch {
    ChunkScratch chunks;

    // Constraints.
    ContactSolver contact_solver;
    JointSystem joint_system;
    std::vector<GroundContact> ground_contacts;  // of seams

    // Falling asleep.
    IslandFinder islands;
    std::vector<Sleeper> sleepers;
    std::vector<std::uint32_t> island_of_root;  // by solver body
    std::vector<JointId> sleeping_joints;

    // Continuous collision.
    std::vector<FreeMotion> free_motions;         // by solver body, of those awake when the step began
    std::vector<Mover> movers;                    // by body index
    std::vector<std::uint32_t> near_shapes;       // indices
    std::vector<ProxyPair> impacts;               // pairs whose impact stopped a body in this step, sorted
    std::vector<StartVelocity> start_velocities;  // by solver body, if impacts are in order
    ImpactScratch ordered_impacts;
    std::vector<ProxyPair> sensor_crossings;  // candidates during the sweep, then those that were crossed, sorted
};

}  // namespace tumble
