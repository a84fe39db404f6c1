#include "dynamics/contacts/chain_crossing.hpp"

#include <algorithm>
#include <functional>

#include "debug/check.hpp"
#include "dynamics/bodies/shape_store.hpp"
#include "dynamics/contacts/contact_store.hpp"
#include "narrow/manifold/link_contact.hpp"

namespace tumble {

namespace {

// The first table.
ChainState next_state(ChainState state, LinkSide side, bool came_through) {
    if (side == LinkSide::apart) return ChainState::apart;
    if (state != ChainState::apart) return state;
    return side == LinkSide::solid || came_through ? ChainState::crossing : ChainState::open;
}

// The second table, if a neighbour decides.
void agree(Contact& contact, ChainState neighbors) {
    TUMBLE_CHECK(neighbors != ChainState::apart);
    const bool begins_to_cross = contact.chain_state == ChainState::open && neighbors == ChainState::crossing;
    contact.chain_state = neighbors;
    if (!begins_to_cross) return;
    remove_manifold(contact);
    contact.reference.invalidate();  // or recycling would restore the manifold
}

bool came_through(const PosedShape& segment, const PosedShape& other, Vec2 displacement, Vec2 normal) {
    if (!(dot(displacement, normal) > 0.0f)) return false;
    const Pose before{other.world_from_body.position - DVec2(displacement), other.world_from_body.rotation};
    return is_behind(segment.record.shape, *segment.record.link, segment.world_from_body, other.record.shape, before);
}

// True for a segment and itself too.
bool continues(const Shape& segment, const Shape& other) {
    const bool is_adjacent = segment.vertex(1) == other.vertex(0) || segment.vertex(0) == other.vertex(1) ||
                             segment.vertex(0) == other.vertex(0);
    return is_adjacent && dot(segment.vertex(1) - segment.vertex(0), other.vertex(1) - other.vertex(0)) > 0.0f;
}

// The state that follows from a shape's contacts with a segment and with those that continue it, except the contacts
// for which is_undecided(contact) holds.
template <class IsUndecided>
ChainState state_of_neighbors(const ChainContacts& chains, const ShapeRecord& segment, std::uint32_t shape,
                              IsUndecided&& is_undecided) {
    ChainState state = ChainState::apart;
    for (const ShapeId id : chains.bodies.records[segment.body].shapes) {
        const ShapeRecord& neighbor = chains.shapes[id.index];
        if (!neighbor.link || !continues(neighbor.shape, segment.shape)) continue;
        const ProxyPair pair = make_pair_of(id.index, shape);
        const Contact* contact = chains.contacts.find(pair);
        if (!contact) contact = chains.contacts.find_in_woken(pair, chains.woken_rounds);
        if (!contact || is_undecided(*contact)) continue;
        if (contact->chain_state == ChainState::crossing) state = ChainState::crossing;
        const bool pushes = contact->manifold.point_count > 0 || contact->was_touching;
        if (contact->chain_state == ChainState::open && pushes) return ChainState::open;
    }
    return state;
}

// The same for a pair; apart if neither is a one-sided segment.
template <class IsUndecided>
ChainState state_of_neighbors(const ChainContacts& chains, ProxyPair pair, IsUndecided&& is_undecided) {
    const bool segment_is_a = chains.shapes[pair.a].link.has_value();
    const ShapeRecord& segment = chains.shapes[segment_is_a ? pair.a : pair.b];
    if (!segment.link || !segment.link->one_sided) return ChainState::apart;
    return state_of_neighbors(chains, segment, segment_is_a ? pair.b : pair.a, is_undecided);
}

}  // namespace

Manifold collide_with_chain(const PosedShape& segment, const PosedShape& other, float reach, Vec2 displacement,
                            Contact& contact) {
    TUMBLE_CHECK(segment.record.link.has_value());
    const LinkContact seen = find_link_contact(segment.record.shape, *segment.record.link, segment.world_from_body,
                                               other.record.shape, other.world_from_body, reach, contact.cache);
    const bool is_first = contact.chain_state == ChainState::apart && seen.side == LinkSide::open;
    const bool through = is_first && came_through(segment, other, displacement, seen.manifold.normal);
    contact.chain_state = next_state(contact.chain_state, seen.side, through);
    return contact.chain_state == ChainState::crossing ? Manifold{} : seen.manifold;
}

void follow_neighbors(const ChainContacts& chains, std::span<Contact> contacts, std::vector<std::uint32_t>& newcomers) {
    if (!chains.crossings.any()) return;
    const auto is_undecided = [&](const Contact& contact) {
        const Contact* const begin = contacts.data();
        const bool is_inside = !std::less<>{}(&contact, begin) && std::less<>{}(&contact, begin + contacts.size());
        return is_inside &&
               std::binary_search(newcomers.begin(), newcomers.end(), static_cast<std::uint32_t>(&contact - begin));
    };
    const auto is_crossing = [&](std::uint32_t i) { return contacts[i].chain_state == ChainState::crossing; };
    std::vector<std::uint32_t> left;
    while (!newcomers.empty()) {
        left.clear();
        for (const std::uint32_t i : newcomers) {
            const ChainState state = state_of_neighbors(chains, contacts[i].shapes, is_undecided);
            state == ChainState::apart ? left.push_back(i) : agree(contacts[i], state);
        }
        const bool is_stuck = left.size() == newcomers.size();
        newcomers.swap(left);
        if (is_stuck && std::erase_if(newcomers, is_crossing) == 0) return;
    }
}

bool crosses_chain(const ChainContacts& chains, ProxyPair pair) {
    TUMBLE_CHECK(pair.a < pair.b);
    return chains.crossings.any() &&
           state_of_neighbors(chains, pair, [](const Contact&) { return false; }) == ChainState::crossing;
}

}  // namespace tumble
