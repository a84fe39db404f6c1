// One-sided chains: which contacts with a chain's segments push, as a state machine for each contact.
//
// A one-sided segment is solid on its left. A shape that comes from the right, the open side, collides with it. A shape
// that comes from the left crosses the chain: half-way through, its middle is already on the open side, where a contact
// would push it away. Therefore each contact with a segment stores the side that the shape came from, until the two are
// apart. A segment of a two-sided chain has two open sides.
//
//   state      meaning                                       manifold
//   apart      farther away than the speculative distance    none
//   open       the shape came from an open side              the segment's; none while the middle is behind it
//   crossing   the shape came from the solid side            none
//
// First transition, at each full collision: by the side on which the middle of the shape is (LinkSide).
//
//   state      side: apart    open                                   solid
//   apart      apart          open, or crossing if it came through   crossing
//   open       apart          open                                   open
//   crossing   apart          crossing                               crossing
//
// The shape came through if it moves away from the segment and its middle was on the solid side one step earlier.
//
// Second transition, for the contacts that left `apart` in this step, the newcomers: by the shape's contacts with the
// segments that continue this one, except undecided newcomers. A newcomer is decided when a neighbour decides. Once no
// neighbour decides any other newcomer, those that are crossing count as decided. Thus a fast shape crosses several new
// segments in one step, whatever their order. A segment continues another if they share a point and turn by less than a
// right angle: beyond that they have no solid side in common.
//
//   state      no neighbour decides   one crosses, none pushes            one is open and pushes
//   open       open                   crossing; the manifold is removed   open
//   crossing   crossing               crossing                            open
//
// So a shape that crosses goes on crossing when it drifts to the next segment, and a shape that a chain supports does
// not begin to cross when its middle is pressed through.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "broad/pair_set.hpp"
#include "tumble/manifold.hpp"
#include "tumble/math.hpp"

namespace tumble {

class BodyStore;
class ContactStore;
class ShapeStore;
struct Contact;
struct ShapeRecord;

enum class ChainState : std::uint8_t { apart, open, crossing };

// Whether a contact may be in the state `crossing`.
struct ChainCrossings {
    bool before = false;  // after the last step's collisions
    bool now = false;     // after those of this step, as far as pairs have been collided

    bool any() const { return before || now; }
};

// What the second transition reads.
struct ChainContacts {
    const BodyStore& bodies;
    const ShapeStore& shapes;
    const ContactStore& contacts;
    ChainCrossings crossings;
    std::span<const std::uint32_t> woken_rounds{};  // of ContactStore::woken(); its other contacts are not read
};

struct PosedShape {
    const ShapeRecord& record;
    const Pose& world_from_body;
};

// The first transition. Returns the manifold from the segment to the other shape, empty unless the contact is open.
// `reach` is the largest gap of a point, m. `displacement` is that of the other shape relative to the segment in a step
// (m, world axes).
Manifold collide_with_chain(const PosedShape& segment, const PosedShape& other, float reach, Vec2 displacement,
                            Contact& contact);

// The second transition. `contacts` is ContactStore::all() or woken(), and `newcomers` are indices of it in ascending
// order; on return, the undecided ones. Contacts of the other list count as decided.
void follow_neighbors(const ChainContacts& chains, std::span<Contact> contacts, std::vector<std::uint32_t>& newcomers);

// True if one of the pair is a one-sided segment and the other crosses it, or a segment that it continues. Costs
// O(segments of the body * log(contacts)), and O(1) while nothing crosses any chain.
bool crosses_chain(const ChainContacts& chains, ProxyPair pair);

}  // namespace tumble
