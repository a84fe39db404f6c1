// The collision of one contact: its manifold in this step, and whether its shapes touch.
#pragma once

#include "dynamics/contacts/contact.hpp"

namespace tumble {

class BodyStore;
class ShapeStore;

// Updates the manifold of a solid contact from the poses and velocities of its bodies. A point keeps its impulses while
// its feature stays the same. `duration` is that of a step, s. Returns false if the manifold was recycled.
bool collide_contact(Contact& contact, const BodyStore& bodies, const ShapeStore& shapes, float duration);

// How fast the two shapes approach each other at a point of the contact's manifold, m/s; negative if they part.
float approach_speed(const Contact& contact, const ManifoldPoint& point, const BodyStore& bodies);

// The manifold of two shapes at any poses, from A to B. Of the contact it reads the speculative distance and the state
// of a chain, and uses the cache; the pair must be that of the contact.
Manifold collide_posed(const PosedShape& a, const PosedShape& b, Contact& contact);

// Updates whether the shapes of a sensor's contact overlap. Such a contact has no manifold, so that the solver has
// nothing to solve.
void sense_contact(Contact& contact, const BodyStore& bodies, const ShapeStore& shapes);

}  // namespace tumble
