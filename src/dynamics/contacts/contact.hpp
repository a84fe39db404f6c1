// A pair of shapes whose boxes overlap, or that touched in the last step, with its manifold and the impulses that warm
// start the next step.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "broad/pair_set.hpp"
#include "dynamics/contacts/chain_crossing.hpp"
#include "dynamics/contacts/manifold_reference.hpp"
#include "tumble/distance.hpp"
#include "tumble/manifold.hpp"

namespace tumble {

// The impulses of one manifold point, N s.
struct PointImpulse {
    float normal = 0.0f;
    float tangent = 0.0f;  // along contact_tangent()

    PointImpulse& operator+=(const PointImpulse& other) {
        normal += other.normal;
        tangent += other.tangent;
        return *this;
    }
};

// Solid contacts push. A sensor's contact only reports that the shapes overlap.
enum class ContactKind : std::uint8_t { solid, sensor_a, sensor_b };

// How two shapes approach each other at a point.
struct Approach {
    DVec2 point;         // world, at the start of the step, or at the impact
    Vec2 normal;         // unit, from A to B, world axes
    float speed = 0.0f;  // m/s, positive if the shapes approach
};

// Most passes over all contacts read the first cache line alone: it ends with the number of manifold points. The solver
// reads the second too, of few contacts the third, and writes the impulses into the first.
struct alignas(64) Contact {
    ProxyPair shapes;          // indices, a < b: contacts are sorted by them
    std::uint32_t body_a = 0;  // index
    std::uint32_t body_b = 0;
    PointImpulse impulses[2];  // by manifold point, of the last sub-step: they warm start the next step
    PointImpulse applied[2];   // by manifold point, of the whole last step
    ContactKind kind = ContactKind::solid;
    ChainState chain_state = ChainState::apart;  // of a chain's segment
    bool is_new = true;                          // not collided since the pair was found or woken
    bool is_bouncing = false;                    // the solver leaves it to continuous collision in this step
    bool is_struck = false;                      // if it bounces: at a point where the shapes touch already
    bool is_touching = false;                    // in this step: the surfaces touched, or an impulse kept them apart
    bool was_touching = false;                   // when events were last reported
    // The manifold point that may report a hit, or -1: the deepest point of a contact that begins, or the deepest one
    // without an impulse if the shapes touched before.
    std::int8_t watched = -1;
    bool was_hit = false;             // a hit was reported in the last step
    std::uint8_t skipped_colors = 0;  // of the free colours of the constraint graph, drawn when the contact began
    bool has_extras = false;          // one of the members from radius_a to tangent_speed is not 0

    Manifold manifold;  // from A to B; anchors from the bodies' origins
    float friction = 0.0f;
    float speculative_distance = 0.0f;  // m; set when the pair is found

    float radius_a = 0.0f;  // of the shapes' rounding, m
    float radius_b = 0.0f;
    float restitution = 0.0f;
    float rolling_resistance = 0.0f;  // m
    float tangent_speed = 0.0f;       // m/s
    float rolling_impulse = 0.0f;     // N m s, of the last sub-step
    SimplexCache cache;
    Approach approach;            // of the watched point
    ManifoldReference reference;  // the last full collision

    template <class Self, class Visitor>
    static void visit_members(Self& self, Visitor&& visit) {
        visit(self.shapes, self.body_a, self.body_b, self.manifold, self.impulses, self.applied, self.rolling_impulse,
              self.kind, self.chain_state, self.is_new, self.is_bouncing, self.is_struck, self.is_touching,
              self.was_touching, self.watched, self.was_hit, self.approach, self.reference, self.cache,
              self.speculative_distance, self.radius_a, self.radius_b, self.friction, self.restitution,
              self.rolling_resistance, self.tangent_speed, self.skipped_colors, self.has_extras);
    }
};
static_assert(offsetof(Contact, manifold) + offsetof(Manifold, normal) == 64);    // the second line
static_assert(offsetof(Contact, radius_a) == 128);                                // the third
static_assert(offsetof(Contact, reference) / 64 == 3 && sizeof(Contact) == 320);  // the fourth and the last

// Loads the first cache lines of a contact.
inline void prefetch(const Contact& contact, std::size_t lines) {
    constexpr std::size_t kCacheLine = 64;
    for (std::size_t line = 0; line < lines; ++line)
        __builtin_prefetch(reinterpret_cast<const char*>(&contact) + line * kCacheLine);
}

// Passes over all contacts start to load this many contacts ahead. The hardware does not foresee such strides well:
// where the contacts fill 19 MB, events and colours take a quarter less time. Eight contacts ahead, a step takes 4 %
// longer.
inline constexpr std::size_t kContactsAhead = 16;

// For passes that read a few members of each contact: loads the first lines of a contact that follows soon.
inline void prefetch_after(std::span<const Contact> contacts, std::size_t index, std::size_t lines) {
    if (index + kContactsAhead < contacts.size()) prefetch(contacts[index + kContactsAhead], lines);
}

// The same for recycling: the first line and the two of the reference (README.md states what it saves).
inline void prefetch_reference_after(std::span<const Contact> contacts, std::size_t index) {
    if (index + kContactsAhead >= contacts.size()) return;
    const Contact& ahead = contacts[index + kContactsAhead];
    prefetch(ahead, 1);
    __builtin_prefetch(&ahead.reference);
    __builtin_prefetch(&ahead.reference.gap);
}

// The tangent of a contact normal: the normal turned clockwise. With B on top of A it points to the right.
constexpr Vec2 contact_tangent(Vec2 normal) { return -perp(normal); }

// False for a point that was foreseen when the step began, and at which the shapes neither pushed nor were near.
// The impulse is read first, as it is in the first cache line.
inline bool is_shown(const Contact& contact, int point) {
    return contact.applied[point].normal > 0.0f ||
           contact.manifold.points[point].separation <= contact.speculative_distance;
}

inline int shown_points(const Contact& contact) {
    int count = 0;
    for (int i = 0; i < contact.manifold.point_count; ++i) count += is_shown(contact, i);
    return count;
}

// Removes the manifold and the impulses: the two shapes do not push each other in this step.
inline void remove_manifold(Contact& contact) {
    contact.manifold.point_count = 0;
    contact.impulses[0] = contact.impulses[1] = {};
    contact.applied[0] = contact.applied[1] = {};
    contact.watched = -1;
    contact.rolling_impulse = 0.0f;
    contact.is_touching = false;
}

}  // namespace tumble
