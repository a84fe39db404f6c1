// The collision of one contact: its manifold in this step, and whether its shapes touch.
#pragma once

#include "dynamics/contacts/contact.hpp"
#include "dynamics/contacts/predicted_manifold.hpp"

namespace tumble {

class BodyStore;
class ShapeStore;

// Updates the manifold of a solid contact from the poses and velocities of its bodies. A point keeps its impulses while
// its feature stays the same. Returns false if the manifold was recycled.
bool collide_contact(Contact& contact, const BodyStore& bodies, const ShapeStore& shapes, const StepAhead& step);

// How fast the two shapes approach each other at a point of the contact's manifold, m/s; negative if they part.
float approach_speed(const Contact& contact, const ManifoldPoint& point, const BodyStore& bodies);

// Updates whether the shapes of a sensor's contact overlap. Such a contact has no manifold, so that the solver has
// nothing to solve.
void sense_contact(Contact& contact, const BodyStore& bodies, const ShapeStore& shapes);

}  // namespace tumble
