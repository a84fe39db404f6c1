#include "dynamics/chain_passes.hpp"

namespace tumble {

namespace {

bool share_an_end(const Shape& a, const Shape& b) {
    for (int i = 0; i < a.vertex_count(); ++i)
        for (int j = 0; j < b.vertex_count(); ++j)
            if (a.vertex(i) == b.vertex(j)) return true;
    return false;
}

}  // namespace

bool passes_chain(Simulation& simulation, ProxyPair pair) {
    if (!simulation.passes.before && !simulation.passes.now) return false;
    const bool link_is_a = simulation.shapes[pair.a].link.has_value();
    const ShapeRecord& link = simulation.shapes[link_is_a ? pair.a : pair.b];
    if (!link.link || !link.link->one_sided) return false;
    const std::uint32_t other = link_is_a ? pair.b : pair.a;
    for (const ShapeId id : simulation.bodies.records[link.body].shapes) {
        const ShapeRecord& segment = simulation.shapes[id.index];
        if (!segment.link || !share_an_end(segment.shape, link.shape)) continue;
        const Contact* const contact = simulation.contacts.find(make_pair_of(id.index, other));
        if (contact && contact->came_from == LinkSide::solid) return true;
    }
    return false;
}

}  // namespace tumble
