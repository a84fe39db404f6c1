// The contact points of an edge of one core and the edge of the other that faces it.
#pragma once

#include "debug/check.hpp"
#include "narrow/distance/small_features.hpp"
#include "narrow/manifold/clip.hpp"
#include "narrow/manifold/reference_edge.hpp"
#include "tumble/manifold.hpp"

namespace tumble {

// The hysteresis of the reference edge as a fraction of the speculative distance: 0.4 mm of 2 cm.
inline constexpr double kReferenceTolerance = 0.02;

inline std::uint32_t contact_feature(int vertex_a, int vertex_b) {
    return static_cast<std::uint32_t>(vertex_a) << 16 | static_cast<std::uint32_t>(vertex_b);
}

// The radii of the two shapes: the distances from their cores to their surfaces (m).
struct Skins {
    double reference;
    double incident;
};

[[gnu::always_inline]] inline Manifold edge_manifold(const CorePair& pair, ReferenceEdge reference, Skins skins,
                                                     double speculative_distance, double tolerance) {
    // By index: a branch on the owner of the edge would be mispredicted half the time.
    const Core* const cores[2] = {&pair.a, &pair.b};
    const bool is_on_a = reference.side == Side::a;
    TUMBLE_CHECK(reference.edge < cores[!is_on_a]->count);
    TUMBLE_CHECK(reference.nearest < cores[is_on_a]->count);
    TUMBLE_CHECK(tolerance >= 0.0);
    const double sign = kSign[!is_on_a];
    const DVec2 shift = sign * pair.offset;
    const ClippedEdge edge = clip(
        {*cores[!is_on_a], *cores[is_on_a], shift, reference.edge, reference.nearest, reference.normal, tolerance});
    Manifold manifold;
    manifold.normal = to_float(sign * edge.normal);
    for (int i = 0; i < edge.count; ++i) {
        const ClippedPoint& point = edge.points[is_on_a ? i : edge.count - 1 - i];
        const double separation = point.separation - (skins.reference + skins.incident);
        if (separation > speculative_distance) continue;
        const DVec2 middle = point.position - (skins.incident + 0.5 * separation) * edge.normal;
        // Number by number: a vector written in halves and read as a whole would stall.
        const DVec2 away = middle - shift;
        TUMBLE_CHECK(manifold.point_count < 2);
        ManifoldPoint& contact = manifold.points[manifold.point_count++];
        contact.anchor_a.x = static_cast<float>(is_on_a ? middle.x : away.x);
        contact.anchor_a.y = static_cast<float>(is_on_a ? middle.y : away.y);
        contact.anchor_b.x = static_cast<float>(is_on_a ? away.x : middle.x);
        contact.anchor_b.y = static_cast<float>(is_on_a ? away.y : middle.y);
        contact.separation = static_cast<float>(separation);
        contact.feature = is_on_a ? contact_feature(point.reference_vertex, point.incident_vertex)
                                  : contact_feature(point.incident_vertex, point.reference_vertex);
    }
    return manifold;
}

}  // namespace tumble
