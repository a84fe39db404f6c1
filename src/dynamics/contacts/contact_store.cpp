#include "dynamics/contacts/contact_store.hpp"

#include <algorithm>

#include "dynamics/bodies/constants.hpp"
#include "dynamics/bodies/shape_store.hpp"

namespace tumble {

namespace {

// The smaller one; a segment has none across and leaves the scale to the other.
float extent_of_pair(float a, float b) {
    const float smaller = std::min(a, b);
    return smaller > 0.0f ? smaller : std::max(a, b);
}

template <class Contacts>
auto* find_in(Contacts& contacts, ProxyPair pair) {
    const auto found = std::lower_bound(contacts.begin(), contacts.end(), pair,
                                        [](const Contact& contact, ProxyPair key) { return contact.shapes < key; });
    return found != contacts.end() && found->shapes == pair ? &*found : nullptr;
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

Contact* ContactStore::find(ProxyPair pair) { return find_in(contacts_, pair); }
const Contact* ContactStore::find(ProxyPair pair) const { return find_in(contacts_, pair); }

void ContactStore::merge_woken() {
    if (woken_.empty()) return;
    std::sort(woken_.begin(), woken_.end(), [](const Contact& a, const Contact& b) { return a.shapes < b.shapes; });
    insert(
        woken_.size(), [&](std::size_t i) { return woken_[i].shapes; }, [&](std::size_t i) { return woken_[i]; });
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

int deepest_point(const Manifold& manifold) {
    return manifold.point_count > 1 && manifold.points[1].separation < manifold.points[0].separation ? 1 : 0;
}

// The deepest point of those that bear nothing yet, or -1.
int idle_point(const Contact& contact) {
    const int deepest = deepest_point(contact.manifold);
    if (contact.impulses[deepest].normal == 0.0f) return deepest;
    const int other = 1 - deepest;
    return other < contact.manifold.point_count && contact.impulses[other].normal == 0.0f ? other : -1;
}

// With the velocities of now: before the step changes any, or for an impact those that it leaves.
void look_at_touch(Contact& contact, const BodyStore& bodies) {
    contact.is_touching = false;
    contact.watched = -1;
    if (contact.manifold.point_count == 0) return;
    const int deepest = deepest_point(contact.manifold);
    contact.is_touching = contact.manifold.points[deepest].separation <= 0.0f;
    const int watched = contact.was_touching ? idle_point(contact) : deepest;
    if (watched < 0) return;
    contact.watched = static_cast<std::int8_t>(watched);
    const ManifoldPoint& point = contact.manifold.points[watched];
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

struct PlacedShape {
    const ShapeRecord& record;
    const Pose& pose;
};

// True for what parts from the segment, and was on its other side a step ago: it was too fast to be seen there.
bool came_through(const PlacedShape& chain, const PlacedShape& other, Vec2 way, const Manifold& manifold) {
    if (!(dot(way, manifold.normal) > 0.0f)) return false;
    const Pose before{other.pose.position - DVec2(way), other.pose.rotation};
    return is_behind(chain.record.shape, *chain.record.link, chain.pose, other.record.shape, before);
}

// The middle of a shape that comes from the solid side reaches the open one while the rest is on its way: that it came
// from behind is remembered until it has passed, or the segment would throw it out. `way`: of the other shape against
// the chain in a step, m.
Manifold collide_with_chain(const PlacedShape& chain, const PlacedShape& other, Vec2 way, Contact& contact) {
    const LinkMeeting met = meet_link(chain.record.shape, *chain.record.link, chain.pose, other.record.shape,
                                      other.pose, contact.speculative_distance, contact.cache);
    const bool is_first = contact.came_from == LinkSide::apart || met.side == LinkSide::apart;
    if (is_first) contact.came_from = came_through(chain, other, way, met.manifold) ? LinkSide::solid : met.side;
    return contact.came_from == LinkSide::solid ? Manifold{} : met.manifold;
}

// The cache belongs to the order of the shapes here: a chain's segment comes first.
Manifold collide_shapes(const PlacedShape& a, const PlacedShape& b, Vec2 way, Contact& contact) {
    if (a.record.link) return collide_with_chain(a, b, way, contact);
    if (b.record.link) return swapped(collide_with_chain(b, a, -way, contact));
    return collide(a.record.shape, a.pose, b.record.shape, b.pose, contact.speculative_distance, contact.cache);
}

void collide_anew(Contact& contact, const PlacedShape& a, const PlacedShape& b, Vec2 way) {
    const Manifold manifold = collide_shapes(a, b, way, contact);
    carry_impulses_over(contact, manifold);
    contact.applied[0] = contact.applied[1] = {};
    contact.manifold = manifold;
    contact.reference = {manifold, a.pose.rotation, b.pose.rotation, b.pose.position - a.pose.position, true};
}

// How far B's centre goes in a step against A's, m: what chains ask for.
Vec2 way_in_step(const Contact& contact, const BodyStore& bodies, float duration) {
    const SolverBody& a = bodies.solver_bodies[bodies.frames[contact.body_a].solver_body];
    const SolverBody& b = bodies.solver_bodies[bodies.frames[contact.body_b].solver_body];
    return duration * (b.velocity - a.velocity);
}

}  // namespace

void drop(Contact& contact) {
    contact.manifold.point_count = 0;
    contact.impulses[0] = contact.impulses[1] = {};
    contact.applied[0] = contact.applied[1] = {};
    contact.watched = -1;
    contact.rolling_impulse = 0.0f;
    contact.is_touching = false;
}

bool collide_contact(Contact& contact, const BodyStore& bodies, const ShapeStore& shapes, float duration) {
    const ShapeRecord& a = shapes[contact.shapes.a];
    const ShapeRecord& b = shapes[contact.shapes.b];
    const Pose& pose_a = bodies.frames[contact.body_a].pose;
    const Pose& pose_b = bodies.frames[contact.body_b].pose;
    const float tolerance = kRecyclingPart * contact.speculative_distance;
    const bool is_recycled = recycle(contact.reference, pose_a, pose_b, a.reach, b.reach, tolerance, contact.manifold);
    if (!is_recycled) {
        const bool is_with_chain = a.link || b.link;
        collide_anew(contact, {a, pose_a}, {b, pose_b},
                     is_with_chain ? way_in_step(contact, bodies, duration) : Vec2{});
    }
    look_at_touch(contact, bodies);
    contact.is_new = false;
    return !is_recycled;
}

void sense_contact(Contact& contact, const BodyStore& bodies, const ShapeStore& shapes) {
    const Pose& a = bodies.frames[contact.body_a].pose;
    const Pose& b = bodies.frames[contact.body_b].pose;
    ManifoldReference& reference = contact.reference;
    const DVec2 offset = b.position - a.position;
    if (!contact.is_new && a.rotation == reference.rotation_a && b.rotation == reference.rotation_b &&
        offset == reference.offset)
        return;
    const Manifold overlap =
        collide(shapes[contact.shapes.a].shape, a, shapes[contact.shapes.b].shape, b, 0.0, contact.cache);
    reference = {{}, a.rotation, b.rotation, offset, false};
    contact.is_touching = overlap.point_count > 0;
    contact.is_new = false;
}

}  // namespace tumble
