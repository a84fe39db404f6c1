// Bodies and contacts for tests of the contact solver, made without a world.
#pragma once

#include "dynamics/bodies/body_store.hpp"
#include "dynamics/contacts/contact.hpp"

namespace tumble::test {

// The mass and inertia count for a dynamic body alone.
inline BodyId add_body(BodyStore& bodies, BodyType type, DVec2 position, float mass, float inertia) {
    BodyDef def;
    def.type = type;
    def.pose.position = position;
    const BodyId id = bodies.create(def);
    bodies.set_mass(id, type == BodyType::dynamic_body ? BodyMass{mass, {}, inertia} : BodyMass{}, 1.0f, 1.0f);
    return id;
}

// With one point.
inline Contact make_touching(BodyId a, BodyId b, Vec2 normal, Vec2 arm_a, Vec2 arm_b, float separation) {
    Contact contact;
    contact.body_a = a.index;
    contact.body_b = b.index;
    contact.friction = 0.5f;
    contact.manifold.normal = normal;
    contact.manifold.point_count = 1;
    contact.manifold.points[0] = {arm_a, arm_b, separation, 0};
    return contact;
}

}  // namespace tumble::test
