// New contacts: what a pair of shapes mixes from its two surfaces.
#pragma once

#include "dynamics/contacts/contact.hpp"

namespace tumble {

class ShapeStore;
struct Tuning;

// A contact of two live shapes that has not been collided.
Contact make_contact(ProxyPair pair, const ShapeStore& shapes, const Tuning& tuning);

// Sets the radii, friction, restitution, rolling resistance and tangent speed of a contact from its shapes.
void mix_surfaces(Contact& contact, const ShapeStore& shapes);

}  // namespace tumble
