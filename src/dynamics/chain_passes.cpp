#include "dynamics/chain_passes.hpp"

namespace tumble {

namespace {

// True for a segment itself too.
bool goes_on(const Shape& segment, const Shape& link) {
    const bool follows = segment.vertex(1) == link.vertex(0) || segment.vertex(0) == link.vertex(1) ||
                         segment.vertex(0) == link.vertex(0);
    return follows && dot(segment.vertex(1) - segment.vertex(0), link.vertex(1) - link.vertex(0)) > 0.0f;
}

}  // namespace

bool passes_chain(const Simulation& simulation, ProxyPair pair) {
    if (!simulation.passes.before && !simulation.passes.now) return false;
    const bool link_is_a = simulation.shapes[pair.a].link.has_value();
    const ShapeRecord& link = simulation.shapes[link_is_a ? pair.a : pair.b];
    if (!link.link || !link.link->one_sided) return false;
    const std::uint32_t other = link_is_a ? pair.b : pair.a;
    for (const ShapeId id : simulation.bodies.records[link.body].shapes) {
        const ShapeRecord& segment = simulation.shapes[id.index];
        if (!segment.link || !goes_on(segment.shape, link.shape)) continue;
        const Contact* const contact = simulation.contacts.find(make_pair_of(id.index, other));
        if (contact && contact->came_from == LinkSide::solid) return true;
    }
    return false;
}

void let_pass(Contact& contact) {
    contact.came_from = LinkSide::solid;
    drop(contact);
    contact.reference.is_valid = false;  // or it would come back by recycling
}

}  // namespace tumble
