#include "dynamics/contacts/collide_posed.hpp"

#include "debug/check.hpp"
#include "dynamics/bodies/shape_store.hpp"
#include "dynamics/contacts/contact.hpp"

namespace tumble {

namespace {

// The same manifold from B to A.
Manifold swapped(const Manifold& manifold) {
    TUMBLE_CHECK(manifold.point_count <= 2);
    Manifold result;
    result.normal = -manifold.normal;
    result.point_count = manifold.point_count;
    for (int i = 0; i < manifold.point_count; ++i) {
        const ManifoldPoint& point = manifold.points[manifold.point_count - 1 - i];
        result.points[i] = {point.anchor_b, point.anchor_a, point.separation,
                            point.feature >> 16 | point.feature << 16};
    }
    return result;
}

}  // namespace

// The cache belongs to the order of the shapes chosen here: a chain's segment comes first.
Manifold collide_posed(const PosedShape& a, const PosedShape& b, Contact& contact, float reach, Vec2 displacement) {
    TUMBLE_CHECK(reach >= 0.0f);
    if (a.record.link) return collide_with_chain(a, b, reach, displacement, contact);
    if (b.record.link) return swapped(collide_with_chain(b, a, reach, -displacement, contact));
    return collide(a.record.shape, a.world_from_body, b.record.shape, b.world_from_body, reach, contact.cache);
}

}  // namespace tumble
