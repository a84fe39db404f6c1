// Memory that impacts in the order of time work in, within a step.
#pragma once

#include <cstdint>
#include <vector>

#include "broad/pair_set.hpp"
#include "broad/tree.hpp"
#include "dynamics/contacts/contact.hpp"
#include "dynamics/impacts/impact_group.hpp"
#include "dynamics/impacts/swept_body.hpp"

namespace tumble {

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
    bool is_shown = false;                       // by a contact
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
    // By the root of a group of touching bodies: how many they are, and how many of its landings are impacts.
    std::vector<std::uint32_t> group_sizes, group_landings;
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
    std::vector<std::uint32_t> bounded_bodies;  // indices, sorted: their motion may need a bound

    void clear_group() {
        group.clear();
        members.clear();
        member_turns.clear();
        group_points.clear();
    }
};

}  // namespace tumble
