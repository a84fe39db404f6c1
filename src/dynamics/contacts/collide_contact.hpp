// The collision of contacts: their manifolds in this step, and whether their shapes touch.
#pragma once

#include <span>

#include "dynamics/bodies/body_store.hpp"
#include "dynamics/contacts/contact.hpp"
#include "dynamics/contacts/predicted_manifold.hpp"

namespace tumble {

class ShapeStore;

// Updates the manifolds of up to eight solid contacts (at least one) from the poses and velocities of their bodies. A
// point keeps its impulses while its feature stays the same. Returns a bit for each contact whose manifold was not
// recycled.
unsigned collide_contacts(std::span<Contact* const> contacts, const BodyStore& bodies, const ShapeStore& shapes,
                          const StepAhead& step);

// How fast the two shapes approach each other at a point of the contact's manifold, m/s; negative if they part.
inline float approach_speed(const Contact& contact, const ManifoldPoint& point, const BodyStore& bodies) {
    const BodyFrame& a = bodies.frames[contact.body_a];
    const BodyFrame& b = bodies.frames[contact.body_b];
    const Vec2 velocity_a = velocity_at(bodies.solver_bodies[a.solver_body], point.anchor_a - a.center_offset);
    const Vec2 velocity_b = velocity_at(bodies.solver_bodies[b.solver_body], point.anchor_b - b.center_offset);
    return dot(velocity_a - velocity_b, contact.manifold.normal);
}

// Updates whether the shapes of a sensor's contact overlap. Such a contact has no manifold, so that the solver has
// nothing to solve.
void sense_contact(Contact& contact, const BodyStore& bodies, const ShapeStore& shapes);

}  // namespace tumble
