#include "narrow/impact/leading_features.hpp"

#include "debug/check.hpp"

namespace tumble {

namespace {

// True if the vertex is higher in the direction than its neighbours, which for a convex core makes it the support.
// Strictly higher: equal neighbours may hide a higher vertex behind them.
bool is_support(const Core& core, int vertex, DVec2 direction) {
    if (core.count == 1) return true;
    const DVec2 local = core.turned_back(direction);
    const double up_to_next = dot(local, core.local_edge(vertex, core.next(vertex)));
    const double up_to_previous = dot(local, core.local_edge(vertex, core.previous(vertex)));
    return up_to_next < 0.0 && up_to_previous < 0.0;
}

bool follow_face(const CorePair& pair, LeadingFeature& feature) {
    const Core* const cores[2] = {&pair.a, &pair.b};
    const Core& owner = *cores[feature.owner];
    const Core& other = *cores[1 - feature.owner];
    const int from = own_vertex(feature.owner, feature.pairs[0]), to = own_vertex(feature.owner, feature.pairs[1]);
    const double sign = kSign[feature.owner];
    TUMBLE_CHECK(feature.owner <= 1u);
    TUMBLE_CHECK(feature.edge_length > 0.0);
    const DVec2 along = owner.turned(feature.local_edge), outwards = -feature.outwards * perp(along);
    const int nearest = support(other, -outwards, own_vertex(1 - feature.owner, feature.pairs[0])).index;
    const DVec2 above = (other.point(nearest) - owner.point(from)) + sign * pair.offset;
    const double foot = dot(along, above);
    feature.distance = dot(outwards, above);
    feature.normal.x = sign * outwards.x;
    feature.normal.y = sign * outwards.y;
    feature.pairs[0] = pair_of_owner(feature.owner, from, nearest);
    feature.pairs[1] = pair_of_owner(feature.owner, to, nearest);
    return (foot > 0.0) & (foot < feature.edge_length) &
           (feature.distance > 0.0);  // else the other core is not in front of the face
}

bool follow_vertices(const CorePair& pair, LeadingFeature& feature) {
    const VertexPair at = feature.pairs[0];
    const DVec2 apart = (pair.b.point(at.b) - pair.a.point(at.a)) + pair.offset;
    feature.distance = length(apart);
    if (!(feature.distance > 0.0)) return false;
    feature.normal.x = apart.x / feature.distance;
    feature.normal.y = apart.y / feature.distance;
    return is_support(pair.a, at.a, apart) && is_support(pair.b, at.b, -apart);
}

}  // namespace

void take(LeadingFeature& feature, const CorePair& pair, const CoreDistance& core) {
    TUMBLE_CHECK(core.pair_count >= 1);
    TUMBLE_CHECK(core.pair_count <= 2);
    const VertexPair first = core.pairs[0], second = core.pairs[core.pair_count - 1];
    feature.distance = core.distance;
    feature.normal.x = core.normal.x;
    feature.normal.y = core.normal.y;
    feature.pairs[0].a = first.a;
    feature.pairs[0].b = first.b;
    feature.pairs[1].a = second.a;
    feature.pairs[1].b = second.b;
    const bool is_same_a = first.a == second.a, is_same_b = first.b == second.b;
    feature.kind = is_same_a && is_same_b ? LeadingFeature::Kind::vertices : LeadingFeature::Kind::none;
    if (is_same_a == is_same_b) return;
    feature.owner = is_same_a;
    const Core* const cores[2] = {&pair.a, &pair.b};
    const Core& owner = *cores[feature.owner];
    const DVec2 edge = owner.local_edge(own_vertex(feature.owner, first), own_vertex(feature.owner, second));
    feature.edge_length = length(edge);
    if (!(feature.edge_length > 0.0)) return;
    feature.kind = LeadingFeature::Kind::face;
    feature.local_edge.x = edge.x / feature.edge_length;
    feature.local_edge.y = edge.y / feature.edge_length;
    feature.outwards = std::copysign(1.0, kSign[feature.owner] * cross(feature.normal, owner.turned(edge)));
}

bool follow(const CorePair& pair, LeadingFeature& feature) {
    switch (feature.kind) {
        case LeadingFeature::Kind::face: return follow_face(pair, feature);
        case LeadingFeature::Kind::vertices: return follow_vertices(pair, feature);
        case LeadingFeature::Kind::none: return false;
    }
    return false;
}

}  // namespace tumble
