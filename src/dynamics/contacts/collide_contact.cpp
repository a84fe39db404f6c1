#include "dynamics/contacts/collide_contact.hpp"

#include <algorithm>
#include <cmath>

#include "debug/check.hpp"
#include "dynamics/bodies/ballistics.hpp"
#include "dynamics/bodies/constants.hpp"
#include "dynamics/bodies/shape_store.hpp"
#include "dynamics/contacts/collide_posed.hpp"
#include "dynamics/contacts/recycling.hpp"

namespace tumble {

namespace {

// Matches the points of the old manifold to those of a new one by their features.
void carry_impulses_over(Contact& contact, const Manifold& manifold) {
    TUMBLE_CHECK(contact.manifold.point_count <= 2);
    TUMBLE_CHECK(manifold.point_count <= 2);
    PointImpulse impulses[2];
    for (int i = 0; i < manifold.point_count; ++i)
        for (int old = 0; old < contact.manifold.point_count; ++old)
            if (contact.manifold.points[old].feature == manifold.points[i].feature) impulses[i] = contact.impulses[old];
    contact.impulses[0] = impulses[0];
    contact.impulses[1] = impulses[1];
    if (manifold.point_count == 0) contact.rolling_impulse = 0.0f;
}

int deepest_point(const Manifold& manifold) {
    return manifold.point_count > 1 && manifold.points[1].separation < manifold.points[0].separation ? 1 : 0;
}

// The deepest point without an impulse, or -1.
int idle_point(const Contact& contact) {
    TUMBLE_CHECK(contact.manifold.point_count > 0);
    const int deepest = deepest_point(contact.manifold);
    if (contact.impulses[deepest].normal == 0.0f) return deepest;
    const int other = 1 - deepest;
    return other < contact.manifold.point_count && contact.impulses[other].normal == 0.0f ? other : -1;
}

// The approach speed at which a point meets the surface, if only gravity and forces act until then, m/s.
float speed_at_impact(const Contact& contact, const ManifoldPoint& point, const BodyStore& bodies,
                      const StepAhead& step) {
    const float speed = approach_speed(contact, point, bodies);
    if (!step.predicts || !(speed > 0.0f) || !(point.separation > 0.0f)) return speed;
    const Vec2 acceleration = bodies.free_acceleration(bodies.frames[contact.body_a].solver_body, step.gravity) -
                              bodies.free_acceleration(bodies.frames[contact.body_b].solver_body, step.gravity);
    const float square = speed_sq_after(speed, point.separation, dot(acceleration, contact.manifold.normal));
    return square > 0.0f ? std::sqrt(square) : speed;
}

// Sets is_touching, and the watched point with its approach. The velocities are those before the step, or after it if
// continuous collision stopped a body.
void update_touch(Contact& contact, const BodyStore& bodies, const StepAhead& step) {
    contact.is_touching = false;
    contact.watched = -1;
    contact.approach = {};
    if (contact.manifold.point_count == 0) return;
    const int deepest = deepest_point(contact.manifold);
    contact.is_touching = contact.manifold.points[deepest].separation <= 0.0f;
    const int watched = contact.was_touching ? idle_point(contact) : deepest;
    if (watched < 0) return;
    TUMBLE_CHECK(watched < contact.manifold.point_count);
    contact.watched = static_cast<std::int8_t>(watched);
    const ManifoldPoint& point = contact.manifold.points[watched];
    // Member by member: copying a struct just after its members were written waits for those writes.
    contact.approach.point = bodies.frames[contact.body_a].pose.position + DVec2(point.anchor_a);
    contact.approach.normal = contact.manifold.normal;
    contact.approach.speed = speed_at_impact(contact, point, bodies, step);
}

void set_manifold(Contact& contact, const Manifold& manifold) {
    TUMBLE_CHECK(manifold.point_count >= 0);
    TUMBLE_CHECK(manifold.point_count <= 2);
    carry_impulses_over(contact, manifold);
    contact.applied[0] = contact.applied[1] = {};
    contact.manifold = manifold;
}

bool is_sharp(const Shape& shape) { return shape.radius() == 0.0f && shape.vertex_count() <= Shape::kInlineVertices; }

// True if a point is at a vertex of the shape.
bool is_at(const PosedShape& shape, unsigned vertex, Vec2 anchor, const Contact& contact) {
    const Vec2 corner = rotate(shape.world_from_body.rotation, shape.record.shape.vertex(static_cast<int>(vertex)));
    return std::abs(cross(contact.manifold.normal, corner - anchor)) < 0.01f * contact.speculative_distance;
}

// ManifoldReference::corners.
float find_corners(const Contact& contact, const PosedShape& a, const PosedShape& b) {
    const Manifold& manifold = contact.manifold;
    const Side side = contact.cache.reference_side;
    const bool are_sharp = is_sharp(a.record.shape) && is_sharp(b.record.shape) && !a.record.link && !b.record.link;
    if (!are_sharp || manifold.point_count == 0 || side == Side::none) return -1.0f;
    int corners = side == Side::b ? 4 : 0;
    for (int i = 0; i < manifold.point_count; ++i) {
        const ManifoldPoint& point = manifold.points[i];
        const bool is_corner = side == Side::a ? is_at(b, point.feature & 0xffffu, point.anchor_b, contact)
                                               : is_at(a, point.feature >> 16, point.anchor_a, contact);
        if (!is_corner) corners += 1 + i;
    }
    return static_cast<float>(corners);
}

void collide_in_full(Contact& contact, const PosedShape& a, const PosedShape& b, Vec2 displacement) {
    const Manifold manifold = collide_posed(a, b, contact, contact.speculative_distance, displacement);
    set_manifold(contact, manifold);
    const bool is_with_chain = a.record.link || b.record.link;
    const float gap = is_with_chain ? 0.0f : std::max(contact.cache.distance - contact.speculative_distance, 0.0f);
    // Member by member, the manifold last: copying a struct just after its members were written waits for those
    // writes.
    ManifoldReference& reference = contact.reference;
    reference.offset = b.world_from_body.position - a.world_from_body.position;
    reference.rotation_a = a.world_from_body.rotation;
    reference.rotation_b = b.world_from_body.rotation;
    reference.reach_a = a.record.reach;
    reference.reach_b = b.record.reach;
    reference.gap = manifold.point_count > 0 ? 0.0f : gap;
    reference.corners = find_corners(contact, a, b);
    reference.tolerance = recycling_tolerance(contact, smaller_extent(a.record, b.record));
    reference.manifold = manifold;
}

// The displacement of B's centre relative to A's in a step, m.
Vec2 displacement_in_step(const Contact& contact, const BodyStore& bodies, float duration) {
    const SolverBody& a = bodies.solver_bodies[bodies.frames[contact.body_a].solver_body];
    const SolverBody& b = bodies.solver_bodies[bodies.frames[contact.body_b].solver_body];
    return duration * (b.velocity - a.velocity);
}

// A circle has one point.
int most_points(const PosedShape& a, const PosedShape& b) {
    return a.record.shape.vertex_count() == 1 || b.record.shape.vertex_count() == 1 ? 1 : 2;
}

// Returns true if the contact has a predicted manifold now. Poses later in the step decide that one, so that it is not
// recycled. `gap` is that of predict_manifold().
bool look_ahead(Contact& contact, const PosedShape& a, const PosedShape& b, float gap, const BodyStore& bodies,
                const StepAhead& step) {
    if (contact.manifold.point_count == most_points(a, b)) return false;
    const Manifold manifold = predict_manifold(contact, a, b, gap, bodies, step);
    if (manifold.point_count == 0) return false;
    set_manifold(contact, manifold);
    contact.reference.invalidate();
    return true;
}

// Returns true if the manifold was not recycled.
bool collide_or_keep(Contact& contact, bool is_recycled, float moved, const BodyStore& bodies, const ShapeStore& shapes,
                     const StepAhead& step) {
    if (!is_recycled || step.predicts) {
        const PosedShape a{shapes[contact.shapes.a], bodies.frames[contact.body_a].pose};
        const PosedShape b{shapes[contact.shapes.b], bodies.frames[contact.body_b].pose};
        const bool is_with_chain = a.record.link || b.record.link;
        if (!is_recycled)
            collide_in_full(contact, a, b,
                            is_with_chain ? displacement_in_step(contact, bodies, step.duration) : Vec2{});
        const float gap = contact.reference.gap - (is_recycled ? moved : 0.0f);
        if (step.predicts && look_ahead(contact, a, b, gap, bodies, step)) is_recycled = false;
    }
    update_touch(contact, bodies, step);
    contact.is_new = false;
    return !is_recycled;
}

}  // namespace

unsigned collide_contacts(std::span<Contact* const> contacts, const BodyStore& bodies, const ShapeStore& shapes,
                          const StepAhead& step) {
    const Recycling recycling = recycle(contacts, bodies);
    unsigned collided = 0;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        TUMBLE_CHECK(contacts[i]->kind == ContactKind::solid);
        const bool is_recycled = recycling.recycled >> i & 1;
        const bool in_full = collide_or_keep(*contacts[i], is_recycled, recycling.moved[i], bodies, shapes, step);
        collided |= static_cast<unsigned>(in_full) << i;
    }
    return collided;
}

void sense_contact(Contact& contact, const BodyStore& bodies, const ShapeStore& shapes) {
    TUMBLE_CHECK(contact.kind != ContactKind::solid);
    TUMBLE_CHECK(contact.manifold.point_count == 0);
    const Pose& a = bodies.frames[contact.body_a].pose;
    const Pose& b = bodies.frames[contact.body_b].pose;
    ManifoldReference& reference = contact.reference;
    const DVec2 offset = b.position - a.position;
    if (!contact.is_new && a.rotation == reference.rotation_a && b.rotation == reference.rotation_b &&
        offset == reference.offset)
        return;
    const Manifold overlap =
        collide(shapes[contact.shapes.a].shape, a, shapes[contact.shapes.b].shape, b, 0.0, contact.cache);
    reference.offset = offset;
    reference.rotation_a = a.rotation;
    reference.rotation_b = b.rotation;
    contact.is_touching = overlap.point_count > 0;
    contact.is_new = false;
}

}  // namespace tumble
