// Contact points from the closest feature: one between two corners, else the incident edge clipped against the
// reference edge.
#include "tumble/manifold.hpp"

#include "debug/check.hpp"
#include "narrow/distance/measure_cores.hpp"
#include "narrow/manifold/edge_manifold.hpp"

namespace tumble {

namespace {

Manifold corner_manifold(const CorePair& pair, const ContactFeature& core, double radius_a, double radius_b) {
    const VertexPair at = core.pairs[0];
    const double separation = core.distance - (radius_a + radius_b);
    TUMBLE_CHECK(at.a < pair.a.count);
    TUMBLE_CHECK(at.b < pair.b.count);
    const DVec2 middle = pair.a.point(at.a) + (radius_a + 0.5 * separation) * core.normal;
    Manifold manifold;
    manifold.normal = to_float(core.normal);
    manifold.point_count = 1;
    manifold.points[0] = {to_float(middle), to_float(middle - pair.offset), static_cast<float>(separation),
                          contact_feature(at.a, at.b)};
    return manifold;
}

// Out of line, with the core distance by reference and its numbers written and read one by one.
[[gnu::always_inline]] inline Manifold manifold_of(const CorePair& pair, const ContactFeature& core, double radius_a,
                                                   double radius_b, double speculative_distance, SimplexCache& cache) {
    TUMBLE_CHECK(core.pair_count >= 1);
    TUMBLE_CHECK(core.pair_count <= 2);
    if (core.distance - (radius_a + radius_b) > speculative_distance) return {};
    const double tolerance = kReferenceTolerance * speculative_distance;
    const ReferenceEdge reference = choose_reference_edge(pair, core, cache, tolerance);
    cache.reference_side = reference.side;
    cache.reference_edge = static_cast<std::uint16_t>(reference.edge);
    if (reference.side == Side::none) return corner_manifold(pair, core, radius_a, radius_b);
    // By index: a branch on the owner of the edge would be mispredicted half the time.
    const double radii[2] = {radius_a, radius_b};
    const bool is_b = reference.side == Side::b;
    const Skins skins{radii[is_b], radii[!is_b]};
    return edge_manifold(pair, reference, skins, speculative_distance, tolerance);
}

}  // namespace

Manifold collide(const Shape& a, const Pose& world_from_a, const Shape& b, const Pose& world_from_b,
                 double speculative_distance, SimplexCache& cache) noexcept {
    const CorePair pair = make_core_pair(a, world_from_a, b, world_from_b);
    cache.distance = 0.0f;
    if (!is_valid(pair, a, b)) return {};
    return measure_cores(
        pair, &cache, [&](const CoreDistance& core) __attribute__((always_inline)) {
            ContactFeature feature;
            feature.distance = core.distance;
            feature.normal.x = core.normal.x;
            feature.normal.y = core.normal.y;
            feature.pairs[0].a = core.pairs[0].a;
            feature.pairs[0].b = core.pairs[0].b;
            feature.pairs[1].a = core.pairs[1].a;
            feature.pairs[1].b = core.pairs[1].b;
            feature.pair_count = core.pair_count;
            cache.iterations = static_cast<std::uint16_t>(core.iterations);
            cache.distance = static_cast<float>(core.distance - (a.radius() + b.radius()));
            return manifold_of(pair, feature, a.radius(), b.radius(), speculative_distance, cache);
        });
}

}  // namespace tumble
