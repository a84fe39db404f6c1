// Contact points from the closest feature: one where corners meet, else the facing edge clipped against a reference edge.
#include "tumble/manifold.hpp"

#include "narrow/clip.hpp"
#include "narrow/measure_cores.hpp"
#include "narrow/reference_edge.hpp"

namespace tumble {

namespace {

// Hysteresis of the reference edge, as a part of the speculative distance: 0.4 mm of 2 cm.
constexpr double kReferenceTolerance = 0.02;

std::uint32_t feature_of(int vertex_a, int vertex_b) {
    return static_cast<std::uint32_t>(vertex_a) << 16 | static_cast<std::uint32_t>(vertex_b);
}

Manifold corner_manifold(const CorePair& pair, const ContactFeature& core, double radius_a, double radius_b) {
    const VertexPair at = core.pairs[0];
    const double separation = core.distance - (radius_a + radius_b);
    const DVec2 middle = pair.a.point(at.a) + (radius_a + 0.5 * separation) * core.normal;
    Manifold manifold;
    manifold.normal = to_float(core.normal);
    manifold.point_count = 1;
    manifold.points[0] = {to_float(middle), to_float(middle - pair.offset), static_cast<float>(separation),
                          feature_of(at.a, at.b)};
    return manifold;
}

struct Skins {
    double reference;
    double incident;
};

Manifold edge_manifold(const CorePair& pair, ReferenceEdge reference, Skins skins, double speculative_distance,
                       double tolerance) {
    // By index: whose edge it is, is as good as random.
    const Core* const cores[2] = {&pair.a, &pair.b};
    const bool is_on_a = reference.side == Side::a;
    const double sign = kSign[!is_on_a];
    const DVec2 shift = sign * pair.offset;
    const ClippedEdge edge = clip({*cores[!is_on_a], *cores[is_on_a], shift, reference.edge, reference.nearest, reference.normal, tolerance});
    Manifold manifold;
    manifold.normal = to_float(sign * edge.normal);
    for (int i = 0; i < edge.count; ++i) {
        const ClippedPoint& point = edge.points[is_on_a ? i : edge.count - 1 - i];
        const double separation = point.separation - (skins.reference + skins.incident);
        if (separation > speculative_distance) continue;
        const DVec2 middle = point.position - (skins.incident + 0.5 * separation) * edge.normal;
        // By single numbers: a vector written by halves and read whole would wait for both.
        const DVec2 away = middle - shift;
        ManifoldPoint& contact = manifold.points[manifold.point_count++];
        contact.anchor_a.x = static_cast<float>(is_on_a ? middle.x : away.x);
        contact.anchor_a.y = static_cast<float>(is_on_a ? middle.y : away.y);
        contact.anchor_b.x = static_cast<float>(is_on_a ? away.x : middle.x);
        contact.anchor_b.y = static_cast<float>(is_on_a ? away.y : middle.y);
        contact.separation = static_cast<float>(separation);
        contact.feature = is_on_a ? feature_of(point.reference_vertex, point.incident_vertex)
                                  : feature_of(point.incident_vertex, point.reference_vertex);
    }
    return manifold;
}

// Out of line and by reference: what is needed of the core distance is written and read number by number.
[[gnu::noinline]] Manifold manifold_of(const CorePair& pair, const ContactFeature& core, double radius_a, double radius_b,
                                       double speculative_distance, SimplexCache& cache) {
    if (core.distance - (radius_a + radius_b) > speculative_distance) return {};
    const double tolerance = kReferenceTolerance * speculative_distance;
    const ReferenceEdge reference = choose_reference_edge(pair, core, cache, tolerance);
    cache.reference_side = reference.side;
    cache.reference_edge = static_cast<std::uint16_t>(reference.edge);
    if (reference.side == Side::none) return corner_manifold(pair, core, radius_a, radius_b);
    const Skins skins = reference.side == Side::a ? Skins{radius_a, radius_b} : Skins{radius_b, radius_a};
    return edge_manifold(pair, reference, skins, speculative_distance, tolerance);
}

}  // namespace

Manifold collide(const Shape& a, const Pose& world_from_a, const Shape& b, const Pose& world_from_b,
                 double speculative_distance, SimplexCache& cache) noexcept {
    const CorePair pair = make_core_pair(a, world_from_a, b, world_from_b);
    if (!is_valid(pair, a, b)) return {};
    return measure_cores(pair, &cache, [&](const CoreDistance& core) __attribute__((always_inline)) {
        ContactFeature feature;
        feature.distance = core.distance;
        feature.normal.x = core.normal.x;
        feature.normal.y = core.normal.y;
        feature.pairs[0].a = core.pairs[0].a;
        feature.pairs[0].b = core.pairs[0].b;
        feature.pairs[1].a = core.pairs[1].a;
        feature.pairs[1].b = core.pairs[1].b;
        feature.pair_count = core.pair_count;
        return manifold_of(pair, feature, a.radius(), b.radius(), speculative_distance, cache);
    });
}

}  // namespace tumble
