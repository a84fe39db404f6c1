// The manifold of a contact's two shapes at given poses.
#pragma once

#include "dynamics/contacts/chain_crossing.hpp"
#include "tumble/manifold.hpp"

namespace tumble {

struct Contact;

// From A to B, with the points whose shapes are at most `reach` (m) apart. Uses the contact's cache, and updates the
// state of a chain; the shapes must be those of the contact. `displacement` is that of B relative to A in the step that
// ends at these poses, m: it tells on which side of a one-sided chain B was.
Manifold collide_posed(const PosedShape& a, const PosedShape& b, Contact& contact, float reach, Vec2 displacement);

}  // namespace tumble
