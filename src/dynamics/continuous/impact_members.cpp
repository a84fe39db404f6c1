#include "dynamics/continuous/impact_members.hpp"

#include <algorithm>
#include <cmath>

#include "debug/check.hpp"
#include "dynamics/bodies/constants.hpp"
#include "dynamics/contacts/collide_posed.hpp"
#include "dynamics/contacts/make_contact.hpp"
#include "dynamics/contacts/separation.hpp"
#include "dynamics/continuous/bounces.hpp"
#include "dynamics/continuous/contact_lists.hpp"
#include "dynamics/continuous/swept_bodies.hpp"
#include "dynamics/impacts/impact_rows.hpp"

namespace tumble {

namespace {

// Points of a group, at most.
constexpr std::size_t kMaxGroupPoints = 128;

float touching_distance(const Contact& contact) { return kTouchingPart * contact.speculative_distance; }

}  // namespace

ImpactMembers::ImpactMembers(Simulation& simulation, const NextImpact& impact)
    : simulation_(simulation),
      scratch_(simulation.scratch->ordered_impacts),
      group_(scratch_.group),
      impact_(impact),
      first_(scratch_.impacts.size()),
      duration_(simulation.settings.duration) {}

void ImpactMembers::begin() {
    clear();
    add_manifold(impact_.shapes, Reach::nearest);
}

void ImpactMembers::begin_at_found_point() {
    clear();
    const Contact contact = make_contact(impact_.shapes, simulation_.shapes, simulation_.settings.tuning);
    const std::size_t a = member(contact.body_a), b = member(contact.body_b);
    add_point(contact, a, b, impact_.normal, impact_.point - center_now(a, contact.body_a),
              impact_.point - center_now(b, contact.body_b), 0.0);
    const DVec2 from_a = impact_.point - pose(contact.body_a, a).position;
    const DVec2 from_b = impact_.point - pose(contact.body_b, b).position;
    Impact& impact = begin_impact(impact_.shapes);
    scratch_.group_points.back().impact = last_impact();
    impact.manifold.normal = to_float(impact_.normal);
    impact.manifold.point_count = 1;
    impact.manifold.points[0] = {to_float(from_a), to_float(from_b), 0.0f, 0};
    record_approach(impact, 0);
}

bool ImpactMembers::grow(double least) {
    const std::size_t before = group_.points.size();
    const std::size_t member_count = scratch_.members.size();
    for (std::size_t i = 0; i < member_count; ++i) {
        if (scratch_.members[i] == kNotSwept || group_.bodies[i].change == Twist{}) continue;
        const std::uint32_t body = scratch_.swept[scratch_.members[i]].body;
        for (const BodyContact& contact : contacts_of(simulation_, body))
            if (may_add(contact.shapes)) add_contact(simulation_.contacts.all()[contact.index], least);
        add_earlier(body, scratch_.swept[scratch_.members[i]].last_impact, least);
    }
    ++group_.depth;
    return group_.points.size() > before;
}

void ImpactMembers::link_impacts() {
    for (std::size_t i = first_; i < scratch_.impacts.size(); ++i) link_impact(simulation_, static_cast<int>(i));
}

void ImpactMembers::clear() {
    scratch_.clear_group();
    scratch_.impacts.resize(first_);
}

// The index in the group of a body; bodies that no impact moves share none.
std::size_t ImpactMembers::member(std::uint32_t body) {
    const BodyFrame& frame = simulation_.bodies.frames[body];
    const bool moves = frame.type != BodyType::static_body &&
                       (frame.solver_body != kStaticSolverBody || simulation_.bodies.is_asleep(body));
    const std::uint32_t swept = moves ? sweep_body(simulation_, body) : kNotSwept;
    const auto found = std::find(scratch_.members.begin(), scratch_.members.end(), swept);
    if (found != scratch_.members.end()) return static_cast<std::size_t>(found - scratch_.members.begin());
    scratch_.members.push_back(swept);
    group_.bodies.push_back(swept == kNotSwept ? ImpactBody{} : make_body(scratch_.swept[swept]));
    scratch_.member_turns.push_back(swept == kNotSwept ? SinCos{} : sin_cos(scratch_.swept[swept].turned()));
    return scratch_.members.size() - 1;
}

ImpactBody ImpactMembers::make_body(SweptBody& swept) {
    swept.advance(impact_.time, duration_);
    return make_impact_body(simulation_, swept);
}

Pose ImpactMembers::pose(std::uint32_t body, std::size_t index) const {
    const std::uint32_t swept = scratch_.members[index];
    return swept == kNotSwept ? simulation_.bodies.frames[body].pose : pose_at(scratch_.swept[swept].sweep, 0.0);
}

DVec2 ImpactMembers::center_now(std::size_t index, std::uint32_t body) const {
    const std::uint32_t swept = scratch_.members[index];
    return swept == kNotSwept ? simulation_.bodies.frames[body].center : scratch_.swept[swept].sweep.start;
}

Twist ImpactMembers::velocity_now(std::uint32_t body) const {
    const std::uint32_t swept = find_swept(simulation_, body);
    const auto found = std::find(scratch_.members.begin(), scratch_.members.end(), swept);
    if (swept == kNotSwept || found == scratch_.members.end()) return present_velocity(simulation_, body);
    const ImpactBody& member = group_.bodies[static_cast<std::size_t>(found - scratch_.members.begin())];
    return member.velocity + member.change;
}

// Of a point between two shapes. The core of a shape turns with the body, but the rounding around the core and the gap
// have no orientation. `from_core` is from the core to the point, m.
ImpactMembers::Arm ImpactMembers::arm(std::uint32_t body, std::size_t index, Vec2 anchor, Vec2 from_core) const {
    const BodyFrame& frame = simulation_.bodies.frames[body];
    const DVec2 before = DVec2(anchor) - DVec2(frame.center_offset);
    if (scratch_.members[index] == kNotSwept) return {before, {}};
    const SinCos turn = scratch_.member_turns[index];
    const DVec2 core = before - DVec2(from_core);
    const DVec2 turned{turn.cos * core.x - turn.sin * core.y, turn.sin * core.x + turn.cos * core.y};
    return {turned + DVec2(from_core), center_now(index, body) - frame.center + (turned - core)};
}

Impact& ImpactMembers::begin_impact(ProxyPair shapes) {
    scratch_.impacts.emplace_back();
    scratch_.impacts.back().shapes = shapes;
    return scratch_.impacts.back();
}

// Of the first point of an impact, for events.
void ImpactMembers::record_approach(Impact& impact, std::size_t first_point) const {
    const ImpactPoint& point = group_.points[first_point];
    const DVec2 at = center_now(point.a, body_of(impact.shapes.a)) + point.arm_a;
    impact.approach = {at, to_float(point.normal), static_cast<float>(-approach_at_impact(group_, point))};
}

// The points of two shapes that touch now, or are nearest.
void ImpactMembers::add_manifold(ProxyPair shapes, Reach reach) {
    Contact contact = make_contact(shapes, simulation_.shapes, simulation_.settings.tuning);
    const std::size_t a = member(contact.body_a), b = member(contact.body_b), before = group_.points.size();
    const Pose pose_a = pose(contact.body_a, a), pose_b = pose(contact.body_b, b);
    const PosedShape shape_a{simulation_.shapes[shapes.a], pose_a}, shape_b{simulation_.shapes[shapes.b], pose_b};
    contact.manifold = collide_posed(shape_a, shape_b, contact, contact.speculative_distance, {});
    const bool must_touch = reach == Reach::bouncing_touch && contact.restitution > 0.0f;
    const float gap = must_touch ? 0.0f : std::max(least_separation(contact.manifold), 0.0f);
    const DVec2 normal(contact.manifold.normal);
    Impact& impact = begin_impact(shapes);
    impact.manifold.normal = contact.manifold.normal;
    for (int i = 0; i < contact.manifold.point_count; ++i) {
        const ManifoldPoint& point = contact.manifold.points[i];
        if (point.separation > gap + touching_distance(contact)) continue;
        const DVec2 at = pose_a.position + DVec2(point.anchor_a);
        add_point(contact, a, b, normal, at - center_now(a, contact.body_a), at - center_now(b, contact.body_b),
                  point.separation);
        scratch_.group_points.back() = {shapes, impact.manifold.point_count, last_impact()};
        impact.manifold.points[impact.manifold.point_count++] = point;
    }
    if (group_.points.size() > before) record_approach(impact, before);
}

void ImpactMembers::add_point(const Contact& contact, std::size_t a, std::size_t b, DVec2 normal, DVec2 arm_a,
                              DVec2 arm_b, double separation) {
    ImpactPoint point;
    point.separation = separation;
    point.a = a;
    point.b = b;
    point.normal = normal;
    point.arm_a = arm_a;
    point.arm_b = arm_b;
    point.friction = contact.friction;
    point.restitution = contact.restitution;
    point.threshold = bounce_threshold(simulation_, contact);
    const auto& frames = simulation_.bodies.frames;  // their inverse masses are without locks
    point.least_response =
        static_cast<double>(kDeadPoint * (frames[contact.body_a].inv_mass + frames[contact.body_b].inv_mass));
    point.tangent_speed = contact.tangent_speed;
    group_.points.push_back(point);
    scratch_.group_points.push_back({contact.shapes});
}

void ImpactMembers::forget_points(std::size_t from) {
    group_.points.resize(from);
    scratch_.group_points.resize(from);
}

bool ImpactMembers::may_add(ProxyPair shapes) const {
    return group_.points.size() < kMaxGroupPoints &&
           std::none_of(scratch_.group_points.begin(), scratch_.group_points.end(),
                        [&](const GroupPoint& own) { return own.shapes == shapes; });
}

// Shapes with restitution collide again if the manifold of the start of the step is out of date: the impulse at a wrong
// arm makes smooth discs spin. Others keep the one from which the solver made their motion: with new ones, 3 of 160
// card houses fall.
void ImpactMembers::add_contact(const Contact& contact, double least) {
    if (contact.restitution == 0.0f) return add_from_start(contact, least);
    const Sweep a = motion_until(simulation_, contact.body_a, impact_.time);
    const Sweep b = motion_until(simulation_, contact.body_b, impact_.time);
    if (!is_out_of_date(contact, a, b))
        add_from_start(contact, least);
    else if (may_touch_now(contact, a, b))
        add_if_approached(contact.shapes, least);
}

// The shapes of earlier impacts of a body in this step may touch still. They need not have a contact.
void ImpactMembers::add_earlier(std::uint32_t body, int last_impact, double least) {
    for (int i = last_impact; i >= 0;) {
        const Impact& earlier = scratch_.impacts[static_cast<std::size_t>(i)];
        i = body_of(earlier.shapes.a) == body ? earlier.previous_of_a : earlier.previous_of_b;
        if (may_add(earlier.shapes)) add_if_approached(ProxyPair(earlier.shapes), least);
    }
}

void ImpactMembers::add_if_approached(ProxyPair shapes, double least) {
    const std::size_t before = group_.points.size();
    add_manifold(shapes, Reach::bouncing_touch);
    const bool is_bound = is_with_immovable(body_of(shapes.a), body_of(shapes.b));
    const bool takes_part = std::any_of(
        group_.points.begin() + static_cast<std::ptrdiff_t>(before), group_.points.end(),
        [&](const ImpactPoint& point) { return is_approached(point, std::max(least, point.threshold), is_bound); });
    if (takes_part) return;
    forget_points(before);
    scratch_.impacts.pop_back();
}

// From the manifold that the contact had when the step began, with anchors that moved with the bodies.
void ImpactMembers::add_from_start(const Contact& contact, double least) {
    const double threshold = std::max(least, bounce_threshold(simulation_, contact));
    const bool is_bound = is_with_immovable(contact.body_a, contact.body_b);
    if (!is_bound && !may_be_approached(contact, threshold)) return;
    const std::size_t a = member(contact.body_a), b = member(contact.body_b), before = group_.points.size();
    bool takes_part = false;
    for (int i = 0; i < contact.manifold.point_count; ++i)
        if (add_point_from_start(contact, contact.manifold.points[i], a, b)) {
            scratch_.group_points.back().manifold_point = i;
            takes_part |= is_approached(group_.points.back(), threshold, is_bound);
        }
    if (!takes_part) forget_points(before);
}

bool ImpactMembers::add_point_from_start(const Contact& contact, const ManifoldPoint& point, std::size_t a,
                                         std::size_t b) {
    const Vec2 normal = contact.manifold.normal;
    const float half_gap = 0.5f * point.separation;
    const Arm arm_a = arm(contact.body_a, a, point.anchor_a, (contact.radius_a + half_gap) * normal);
    const Arm arm_b = arm(contact.body_b, b, point.anchor_b, -(contact.radius_b + half_gap) * normal);
    const double separation = static_cast<double>(point.separation) + dot(arm_b.shift - arm_a.shift, DVec2(normal));
    add_point(contact, a, b, DVec2(normal), arm_a.now, arm_b.now, separation);
    if (separation <= largest_gap(contact, group_.points.back())) return true;
    forget_points(group_.points.size() - 1);
    return false;
}

// Static and kinematic bodies bound all others: their contacts take part however slow the approach is.
bool ImpactMembers::is_with_immovable(std::uint32_t a, std::uint32_t b) const {
    return !simulation_.bodies.is_dynamic(a) || !simulation_.bodies.is_dynamic(b);
}

bool ImpactMembers::is_approached(const ImpactPoint& point, double least, bool is_bound) const {
    if (is_bound) return approach_at_impact(group_, point) < 0.0 || approach_ahead(group_, point) < 0.0;
    return approach_at_impact(group_, point) < -least;
}

// A quick test, which adds no members. The arms are those of the start of the step.
bool ImpactMembers::may_be_approached(const Contact& contact, double threshold) const {
    const Twist a = velocity_now(contact.body_a), b = velocity_now(contact.body_b);
    const DVec2 normal(contact.manifold.normal);
    for (int i = 0; i < contact.manifold.point_count; ++i) {
        const ManifoldPoint& point = contact.manifold.points[i];
        const DVec2 arm_a(point.anchor_a - simulation_.bodies.frames[contact.body_a].center_offset);
        const DVec2 arm_b(point.anchor_b - simulation_.bodies.frames[contact.body_b].center_offset);
        const DVec2 speed = b.linear + b.angular * perp(arm_b) - a.linear - a.angular * perp(arm_a);
        if (dot(speed, normal) < -0.5 * threshold) return true;
    }
    return false;
}

// True if the cores of the shapes have moved against each other by more than the speculative distance since the step
// began, by the motions of their bodies until the impact.
bool ImpactMembers::is_out_of_date(const Contact& contact, const Sweep& a, const Sweep& b) const {
    const auto arc = [&](const Sweep& motion, std::uint32_t shape, float radius) {
        return std::abs(motion.turn) *
               static_cast<double>(farthest_distance(simulation_.shapes[shape].shape, motion.local_center) - radius);
    };
    const double moved = length((b.end - b.start) - (a.end - a.start)) + arc(a, contact.shapes.a, contact.radius_a) +
                         arc(b, contact.shapes.b, contact.radius_b);
    return moved > static_cast<double>(contact.speculative_distance);
}

// A quick test, which adds no members: the discs around the two shapes overlap, or nearly.
bool ImpactMembers::may_touch_now(const Contact& contact, const Sweep& a, const Sweep& b) const {
    const float reach = farthest_distance(simulation_.shapes[contact.shapes.a].shape, a.local_center) +
                        farthest_distance(simulation_.shapes[contact.shapes.b].shape, b.local_center);
    return length(b.end - a.end) <= static_cast<double>(reach + contact.speculative_distance);
}

// The largest gap of a point that takes part. Without a bounce it may close in the rest of the step: otherwise a stack
// that lands has too many impacts for a step, and ten boxes that fall by 5 m rebound at 7 m/s.
double ImpactMembers::largest_gap(const Contact& contact, const ImpactPoint& point) const {
    const auto has_joints = [&](std::uint32_t body) { return !simulation_.bodies.records[body].joints.empty(); };
    const float touching = touching_distance(contact);
    if (contact.restitution > 0.0f || has_joints(contact.body_a) || has_joints(contact.body_b)) return touching;
    const double closed = -approach_at_impact(group_, point) * (1.0 - impact_.time) * duration_;
    return std::clamp<double>(closed, touching, contact.speculative_distance);
}

}  // namespace tumble
