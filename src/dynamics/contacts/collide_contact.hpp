// The collision of one contact: its manifold in this step, and whether its shapes touch.
#pragma once

#include "dynamics/bodies/body_store.hpp"
#include "dynamics/contacts/contact.hpp"
#include "dynamics/contacts/predicted_manifold.hpp"

namespace tumble {

class ShapeStore;

// Updates the manifold of a solid contact from the poses and velocities of its bodies. A point keeps its impulses while
// its feature stays the same. Returns false if the manifold was recycled.
bool collide_contact(Contact& contact, const BodyStore& bodies, const ShapeStore& shapes, const StepAhead& step);

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
