#include "narrow/manifold/reference_edge.hpp"

#include "debug/check.hpp"
#include "narrow/distance/small_features.hpp"

namespace tumble {

namespace {

const Core& core_of(const CorePair& pair, Side side) { return side == Side::a ? pair.a : pair.b; }

FoundFace face_of(const CorePair& pair, ReferenceEdge reference) {
    return reference.side == Side::a ? face_of_a(pair, reference.edge) : face_of_b(pair, reference.edge);
}

// The edge between two neighbouring vertices whose outward normal points along `outward`; none if the vertices are not
// neighbours.
ReferenceEdge edge_between_vertices(const Core& core, Side side, int first, int second, DVec2 outward) {
    TUMBLE_CHECK(first < core.count);
    TUMBLE_CHECK(second < core.count);
    const bool is_forward = dot(-perp(core.edge(first, second)), outward) > 0.0;
    const int from = is_forward ? first : second, to = is_forward ? second : first;
    return core.next(from) == to ? ReferenceEdge{side, from, -1, {}} : ReferenceEdge{};
}

// Two corners count as an edge contact if the face beside one of them is within a hundredth of a radian of the normal:
// a stack of equal boxes stays upright on two points, not on one.
ReferenceEdge square_edge_at(const Core& core, Side side, int vertex, DVec2 outward) {
    constexpr double kSquareCosine = 1.0 - 0.5e-4;
    TUMBLE_CHECK(vertex < core.count);
    for (const int edge : {core.previous(vertex), vertex}) {
        const DVec2 direction = -perp(core.edge(edge, core.next(edge)));
        if (dot(direction, outward) > kSquareCosine * length(direction)) return {side, edge, -1, {}};
    }
    return {};
}

// The edge is chosen by the direction of the face: its ends are in either order, and the two edges of a segment have
// the same ends.
ReferenceEdge edge_of_face(const CorePair& pair, const Face& face) {
    const bool is_on_a = face.pairs[0].b == face.pairs[1].b && pair.a.count > 1;
    const int from = is_on_a ? face.pairs[0].a : face.pairs[0].b, to = is_on_a ? face.pairs[1].a : face.pairs[1].b;
    const Side side = is_on_a ? Side::a : Side::b;
    return edge_between_vertices(core_of(pair, side), side, from, to, kSign[!is_on_a] * face.direction);
}

ReferenceEdge deepest_edge(const CorePair& pair) {
    const FoundFace deepest = deepest_face(pair);
    return deepest.exists ? edge_of_face(pair, deepest.face) : ReferenceEdge{};
}

ReferenceEdge edge_at_corners(const CorePair& pair, const ContactFeature& core, double tolerance) {
    if (core.distance <= tolerance) return deepest_edge(pair);  // too near for a steady direction between them
    if (pair.a.count == 1 || pair.b.count == 1) return {};
    const VertexPair at = core.pairs[0];
    const ReferenceEdge found = square_edge_at(pair.a, Side::a, at.a, core.normal);
    return found.side != Side::none ? found : square_edge_at(pair.b, Side::b, at.b, -core.normal);
}

void set(ReferenceEdge& edge, const ReferenceEdge& found) {
    edge.side = found.side;
    edge.edge = found.edge;
    edge.nearest = found.nearest;
    edge.normal.x = found.normal.x;
    edge.normal.y = found.normal.y;
}

// For ends in either order, and for segments. The deepest edge if the ends are not neighbours.
void search_edge_of_ends(const CorePair& pair, const ContactFeature& core, ReferenceEdge& edge) {
    if (!set_edge_of_ends(pair, core, edge)) {
        const VertexPair last = core.pairs[1];
        const int to = edge.side == Side::a ? last.a : last.b;
        const ReferenceEdge found =
            edge_between_vertices(core_of(pair, edge.side), edge.side, edge.edge, to, edge.normal);
        if (found.side == Side::none) return set(edge, deepest_edge(pair));
        edge.edge = found.edge;
    }
    if (has_common_vertex(core)) return;
    edge.nearest = -1;
    edge.normal.x = 0.0;
    edge.normal.y = 0.0;
}

bool is_usable(const CorePair& pair, ReferenceEdge reference) {
    if (reference.side != Side::a && reference.side != Side::b) return false;
    const Core& core = core_of(pair, reference.side);
    return core.count > 1 && reference.edge < core.count;
}

}  // namespace

// One result, written number by number: a copy of a structure that was just stored in parts would stall.
ReferenceEdge search_reference_edge(const CorePair& pair, const ContactFeature& core, const SimplexCache& cache,
                                    double tolerance) {
    ReferenceEdge best;
    if (pair.a.count == 1 && pair.b.count == 1) return best;
    if (core.pair_count == 1) {
        set(best, edge_at_corners(pair, core, tolerance));
    } else {
        search_edge_of_ends(pair, core, best);
    }
    TUMBLE_CHECK((best.side == Side::none || best.edge < core_of(pair, best.side).count));
    const int other_side = static_cast<int>(cache.reference_side) - static_cast<int>(best.side);
    const int other_edge = static_cast<int>(cache.reference_edge) - best.edge;
    if ((other_side | other_edge) == 0 || best.side == Side::none) return best;
    const ReferenceEdge previous{cache.reference_side, cache.reference_edge, -1, {}};
    if (!is_usable(pair, previous)) return best;
    const FoundFace kept = face_of(pair, previous);
    if (kept.exists && kept.face.separation >= core.distance - tolerance) set(best, previous);
    return best;
}

}  // namespace tumble
