// New contacts: what a pair of shapes mixes from its two surfaces, and the draw of its colour.
#pragma once

#include "dynamics/contacts/contact.hpp"

namespace tumble {

class BodyStore;
class ShapeStore;
struct Tuning;

// A contact of two live shapes that has not been collided.
Contact make_contact(ProxyPair pair, const ShapeStore& shapes, const Tuning& tuning);

// Draws how many free colours a contact between dynamic bodies skips, 0 to 3 (constraint_graph.hpp). The draw is a hash
// of the earlier draws of its two bodies: it depends neither on where the world is nor on bodies that no contacts have
// linked to them.
void draw_colors(Contact& contact, BodyStore& bodies);

// Sets the radii, friction, restitution, rolling resistance and tangent speed of a contact from its shapes.
void mix_surfaces(Contact& contact, const ShapeStore& shapes);

}  // namespace tumble
