#include "dynamics/stages/chain_passes.hpp"

#include <utility>

namespace tumble {

namespace {

// True for a segment itself too.
bool goes_on(const Shape& segment, const Shape& link) {
    const bool follows = segment.vertex(1) == link.vertex(0) || segment.vertex(0) == link.vertex(1) ||
                         segment.vertex(0) == link.vertex(0);
    return follows && dot(segment.vertex(1) - segment.vertex(0), link.vertex(1) - link.vertex(0)) > 0.0f;
}

// The side from which the shape has met the segment, or others that go on from it: open if any holds it.
LinkSide side_met(const Simulation& simulation, const ShapeRecord& link, std::uint32_t other) {
    LinkSide side = LinkSide::apart;
    for (const ShapeId id : simulation.bodies.records[link.body].shapes) {
        const ShapeRecord& segment = simulation.shapes[id.index];
        if (!segment.link || !goes_on(segment.shape, link.shape)) continue;
        const Contact* const contact = simulation.contacts.find(make_pair_of(id.index, other));
        if (!contact) continue;
        if (contact->came_from == LinkSide::solid) side = LinkSide::solid;
        const bool holds = contact->manifold.point_count > 0 || contact->was_touching;
        if (contact->came_from == LinkSide::open && holds) return LinkSide::open;
    }
    return side;
}

LinkSide side_met(const Simulation& simulation, ProxyPair pair) {
    const bool link_is_a = simulation.shapes[pair.a].link.has_value();
    const ShapeRecord& link = simulation.shapes[link_is_a ? pair.a : pair.b];
    if (!link.link || !link.link->one_sided) return LinkSide::apart;
    return side_met(simulation, link, link_is_a ? pair.b : pair.a);
}

}  // namespace

bool passes_chain(const Simulation& simulation, ProxyPair pair) {
    if (!simulation.chain_crossings.before && !simulation.chain_crossings.now) return false;
    return side_met(simulation, pair) == LinkSide::solid;
}

void keep_side(const Simulation& simulation, Contact& contact) {
    const LinkSide found = std::exchange(contact.came_from, LinkSide::apart);
    const bool may_pass = simulation.chain_crossings.before || simulation.chain_crossings.now;
    const LinkSide met = found == LinkSide::solid || may_pass ? side_met(simulation, contact.shapes) : LinkSide::apart;
    contact.came_from = met == LinkSide::apart ? found : met;
    if (found != LinkSide::open || met != LinkSide::solid) return;
    drop(contact);
    contact.reference.is_valid = false;  // or it would come back by recycling
}

}  // namespace tumble
