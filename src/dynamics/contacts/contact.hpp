// A pair of shapes whose boxes overlap, with its manifold and the impulses that warm the next step.
#pragma once

#include <cmath>
#include <cstdint>

#include "broad/pair_set.hpp"
#include "dynamics/contacts/recycling.hpp"
#include "narrow/manifold/link_meeting.hpp"
#include "tumble/body.hpp"
#include "tumble/manifold.hpp"

namespace tumble {

// The impulses of one manifold point, N s.
struct PointImpulse {
    float normal = 0.0f;
    float tangent = 0.0f;  // along the tangent, the normal turned clockwise
};

// What a pair of shapes is to the world: solid, or one of them a sensor that only notices the other.
enum class ContactKind : std::uint8_t { solid, sensor_a, sensor_b };

// How two shapes meet at a point where they did not before.
struct Approach {
    DVec2 point;         // world, at the start of the step
    float speed = 0.0f;  // m/s, positive if they near each other
};

struct Contact {
    ProxyPair shapes;          // by index, a < b: the order of contacts
    std::uint32_t body_a = 0;  // by index
    std::uint32_t body_b = 0;
    Manifold manifold;         // anchors from the bodies' origins
    PointImpulse impulses[2];  // by manifold point, of the last sub-step: what the next step is warmed with
    PointImpulse applied[2];   // the same of the whole last step
    float rolling_impulse = 0.0f;
    ContactKind kind = ContactKind::solid;
    LinkSide came_from = LinkSide::apart;  // of a chain's segment, until they have parted: what passes it passes whole
    bool is_new = true;                    // not collided since it was found or woke
    bool is_touching = false;              // in this step: surfaces met, or an impulse kept them apart
    bool was_touching = false;             // when events were last reported
    std::int8_t watched = -1;     // the point that may be struck: the deepest, or of who touched one that bore nothing
    bool was_hit = false;         // a hit was reported in the last step
    Approach approach;            // of the watched point
    ManifoldReference reference;  // the last full collision
    SimplexCache cache;
    // Of the pair, mixed once when it is found.
    float speculative_distance = 0.0f;
    float radius_a = 0.0f;  // of the shapes' rounding, m
    float radius_b = 0.0f;
    float friction = 0.0f;
    float restitution = 0.0f;
    float rolling_resistance = 0.0f;  // m
    float tangent_speed = 0.0f;       // m/s

    template <class Self, class Visitor>
    static void visit_members(Self& self, Visitor&& visit) {
        visit(self.shapes, self.body_a, self.body_b, self.manifold, self.impulses, self.applied, self.rolling_impulse,
              self.kind, self.came_from, self.is_new, self.is_touching, self.was_touching, self.watched, self.was_hit,
              self.approach, self.reference, self.cache, self.speculative_distance, self.radius_a, self.radius_b,
              self.friction, self.restitution, self.rolling_resistance, self.tangent_speed);
    }
};

// The tangent of a contact normal: with B on top of A it points to the right.
constexpr Vec2 contact_tangent(Vec2 normal) { return -perp(normal); }

inline float mix_friction(const SurfaceMaterial& a, const SurfaceMaterial& b) {
    return std::sqrt(a.friction * b.friction);
}
constexpr float mix_restitution(const SurfaceMaterial& a, const SurfaceMaterial& b) {
    return a.restitution > b.restitution ? a.restitution : b.restitution;
}
constexpr float mix_rolling_resistance(const SurfaceMaterial& a, const SurfaceMaterial& b) {
    return a.rolling_resistance > b.rolling_resistance ? a.rolling_resistance : b.rolling_resistance;
}
constexpr float mix_tangent_speed(const SurfaceMaterial& a, const SurfaceMaterial& b) {
    return a.tangent_speed + b.tangent_speed;
}

}  // namespace tumble
