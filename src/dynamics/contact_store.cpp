#include "dynamics/contact_store.hpp"

#include <algorithm>

#include "dynamics/constants.hpp"
#include "dynamics/shape_store.hpp"

namespace tumble {

namespace {

// The smaller one; a segment has none across and leaves the scale to the other.
float extent_of_pair(float a, float b) {
    const float smaller = std::min(a, b);
    return smaller > 0.0f ? smaller : std::max(a, b);
}

}  // namespace

void mix_surfaces(Contact& contact, const ShapeStore& shapes) {
    const ShapeRecord& a = shapes[contact.shapes.a];
    const ShapeRecord& b = shapes[contact.shapes.b];
    contact.radius_a = a.shape.radius();
    contact.radius_b = b.shape.radius();
    contact.friction = mix_friction(a.material, b.material);
    contact.restitution = mix_restitution(a.material, b.material);
    contact.rolling_resistance =
        mix_rolling_resistance(a.material, b.material) * std::max(a.shape.radius(), b.shape.radius());
    contact.tangent_speed = mix_tangent_speed(a.material, b.material);
}

Contact make_contact(ProxyPair pair, const ShapeStore& shapes, const Tuning& tuning) {
    const ShapeRecord& a = shapes[pair.a];
    const ShapeRecord& b = shapes[pair.b];
    Contact contact;
    contact.shapes = pair;
    contact.body_a = a.body;
    contact.body_b = b.body;
    contact.speculative_distance = tuning.speculative_distance(extent_of_pair(a.smaller_extent, b.smaller_extent));
    if (a.is_sensor) contact.kind = ContactKind::sensor_a;
    if (b.is_sensor) contact.kind = ContactKind::sensor_b;
    mix_surfaces(contact, shapes);
    return contact;
}

void ContactStore::merge_woken() {
    if (woken_.empty()) return;
    std::sort(woken_.begin(), woken_.end(), [](const Contact& a, const Contact& b) { return a.shapes < b.shapes; });
    insert(woken_.size(), [&](std::size_t i) { return woken_[i].shapes; }, [&](std::size_t i) { return woken_[i]; });
    woken_.clear();
}

namespace {

void carry_impulses_over(Contact& contact, const Manifold& manifold) {
    PointImpulse impulses[2];
    for (int i = 0; i < manifold.point_count; ++i)
        for (int old = 0; old < contact.manifold.point_count; ++old)
            if (contact.manifold.points[old].feature == manifold.points[i].feature) impulses[i] = contact.impulses[old];
    contact.impulses[0] = impulses[0];
    contact.impulses[1] = impulses[1];
    if (manifold.point_count == 0) contact.rolling_impulse = 0.0f;
}

const ManifoldPoint& deepest_point(const Manifold& manifold) {
    const bool second = manifold.point_count > 1 && manifold.points[1].separation < manifold.points[0].separation;
    return manifold.points[second ? 1 : 0];
}

// With the velocities of now: before the step changes any, or for an impact those that it leaves.
void look_at_touch(Contact& contact, const BodyStore& bodies) {
    contact.is_touching = false;
    if (contact.manifold.point_count == 0) return;
    const ManifoldPoint& point = deepest_point(contact.manifold);
    contact.is_touching = point.separation <= 0.0f;
    if (contact.was_touching) return;
    const BodyFrame& a = bodies.frames[contact.body_a];
    const BodyFrame& b = bodies.frames[contact.body_b];
    const Vec2 velocity_a = velocity_at(bodies.solver_bodies[a.solver_body], point.anchor_a - a.center_offset);
    const Vec2 velocity_b = velocity_at(bodies.solver_bodies[b.solver_body], point.anchor_b - b.center_offset);
    contact.approach = {a.pose.position + DVec2(point.anchor_a), dot(velocity_a - velocity_b, contact.manifold.normal)};
}

// The same manifold seen from the other body.
Manifold swapped(const Manifold& manifold) {
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

// The cache belongs to the order of the shapes here: a chain's segment comes first.
Manifold collide_shapes(const ShapeRecord& a, const Pose& pose_a, const ShapeRecord& b, const Pose& pose_b,
                        Contact& contact) {
    const float speculative = contact.speculative_distance;
    if (a.link) return collide_link(a.shape, *a.link, pose_a, b.shape, pose_b, speculative, contact.cache);
    if (b.link) return swapped(collide_link(b.shape, *b.link, pose_b, a.shape, pose_a, speculative, contact.cache));
    return collide(a.shape, pose_a, b.shape, pose_b, speculative, contact.cache);
}

void collide_anew(Contact& contact, const ShapeRecord& a, const Pose& pose_a, const ShapeRecord& b,
                  const Pose& pose_b) {
    const Manifold manifold = collide_shapes(a, pose_a, b, pose_b, contact);
    carry_impulses_over(contact, manifold);
    contact.manifold = manifold;
    contact.reference = {manifold, pose_a.rotation, pose_b.rotation, pose_b.position - pose_a.position, true};
}

}  // namespace

bool collide_contact(Contact& contact, const BodyStore& bodies, const ShapeStore& shapes) {
    const ShapeRecord& a = shapes[contact.shapes.a];
    const ShapeRecord& b = shapes[contact.shapes.b];
    const Pose& pose_a = bodies.frames[contact.body_a].pose;
    const Pose& pose_b = bodies.frames[contact.body_b].pose;
    const float tolerance = kRecyclingPart * contact.speculative_distance;
    const bool is_recycled =
        recycle(contact.reference, pose_a, pose_b, a.reach, b.reach, tolerance, contact.manifold);
    if (!is_recycled) collide_anew(contact, a, pose_a, b, pose_b);
    look_at_touch(contact, bodies);
    contact.is_new = false;
    return !is_recycled;
}

void sense_contact(Contact& contact, const BodyStore& bodies, const ShapeStore& shapes) {
    const Manifold overlap =
        collide(shapes[contact.shapes.a].shape, bodies.frames[contact.body_a].pose, shapes[contact.shapes.b].shape,
                bodies.frames[contact.body_b].pose, 0.0, contact.cache);
    contact.is_touching = overlap.point_count > 0;
    contact.is_new = false;
}

}  // namespace tumble
