#include "dynamics/continuous/impact_response.hpp"

#include <algorithm>

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

// An impact goes on through a touching contact if it gives it an approach above the threshold of bounces, and at least
// this part of its own approach speed. Smaller: impacts on piles cost more (in a tumbler of 2000 boxes five times as
// much at 0.1). Larger: elastic bodies that touch several others lose energy.
constexpr double kPassedOn = 0.3;

// Of an impact without a bounce; one with a bounce weighs 1. Larger: bodies of fast piles stop sooner, and sink deeper.
// Smaller: their step costs a hundred times as much.
constexpr int kInelasticWeight = 8;

class ImpactResponse {
public:
    ImpactResponse(Simulation& simulation, const NextImpact& impact)
        : simulation_(simulation),
          scratch_(simulation.scratch->ordered_impacts),
          group_(scratch_.group),
          impact_(impact),
          first_(scratch_.impacts.size()),
          duration_(simulation.settings.duration) {}

    void run() {
        clear();
        add_manifold(impact_.shapes);
        solve();
        if (!has_changed() && impact_.normal != DVec2{}) {
            clear();
            add_touching_point();
            solve();
        }
        for (std::size_t i = 0; i < scratch_.members.size(); ++i) apply(i);
        store_impulses();
        for (std::size_t i = first_; i < scratch_.impacts.size(); ++i) link_impact(simulation_, static_cast<int>(i));
    }

private:
    void clear() {
        scratch_.clear_group();
        scratch_.impacts.resize(first_);
    }

    void solve() {
        double fastest = 0.0;
        for (const ImpactPoint& point : group_.points) fastest = std::max(fastest, -approach_at_impact(group_, point));
        record_approach();
        do {
            solve_impacts(group_);
        } while (grow(kPassedOn * fastest));
    }

    // The index in the group of a body; bodies that no impact moves share none.
    std::size_t member(std::uint32_t body) {
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

    ImpactBody make_body(SweptBody& swept) {
        swept.advance(impact_.time, duration_);
        return make_impact_body(simulation_, swept);
    }

    Pose pose(std::uint32_t body, std::size_t index) const {
        const std::uint32_t swept = scratch_.members[index];
        return swept == kNotSwept ? simulation_.bodies.frames[body].pose : pose_at(scratch_.swept[swept].sweep, 0.0);
    }

    Impact& begin_impact(ProxyPair shapes) {
        scratch_.impacts.emplace_back();
        scratch_.impacts.back().shapes = shapes;
        return scratch_.impacts.back();
    }

    // The points at which two shapes touch now.
    void add_manifold(ProxyPair shapes) {
        Contact contact = make_contact(shapes, simulation_.shapes, simulation_.settings.tuning);
        const std::size_t a = member(contact.body_a), b = member(contact.body_b);
        const Pose pose_a = pose(contact.body_a, a), pose_b = pose(contact.body_b, b);
        const PosedShape shape_a{simulation_.shapes[shapes.a], pose_a}, shape_b{simulation_.shapes[shapes.b], pose_b};
        contact.manifold = collide_posed(shape_a, shape_b, contact, contact.speculative_distance, {});
        const float depth = std::max(least_separation(contact.manifold), 0.0f) + touching_distance(contact);
        Manifold& taking_part = begin_impact(shapes).manifold;
        taking_part.normal = contact.manifold.normal;
        for (int i = 0; i < contact.manifold.point_count; ++i) {
            const ManifoldPoint& point = contact.manifold.points[i];
            if (point.separation > depth) continue;
            add_point(contact, a, b, DVec2(contact.manifold.normal), pose_a.position + DVec2(point.anchor_a),
                      point.separation);
            scratch_.group_points.back() = {shapes, taking_part.point_count, last_impact()};
            taking_part.points[taking_part.point_count++] = point;
        }
    }

    int last_impact() const { return static_cast<int>(scratch_.impacts.size()) - 1; }

    // The point that the search has found: a manifold of shapes that overlap deeply may have another normal.
    void add_touching_point() {
        const Contact contact = make_contact(impact_.shapes, simulation_.shapes, simulation_.settings.tuning);
        const std::size_t a = member(contact.body_a), b = member(contact.body_b);
        add_point(contact, a, b, impact_.normal, impact_.point, 0.0);
        const DVec2 from_a = impact_.point - pose(contact.body_a, a).position;
        const DVec2 from_b = impact_.point - pose(contact.body_b, b).position;
        Manifold& manifold = begin_impact(impact_.shapes).manifold;
        scratch_.group_points.back().impact = last_impact();
        manifold.normal = to_float(impact_.normal);
        manifold.point_count = 1;
        manifold.points[0] = {to_float(from_a), to_float(from_b), 0.0f, 0};
    }

    DVec2 center_now(std::size_t index, std::uint32_t body) const {
        const std::uint32_t swept = scratch_.members[index];
        return swept == kNotSwept ? simulation_.bodies.frames[body].center : scratch_.swept[swept].sweep.start;
    }

    void add_point(const Contact& contact, std::size_t a, std::size_t b, DVec2 normal, DVec2 at, double separation) {
        add_point(contact, a, b, normal, at - center_now(a, contact.body_a), at - center_now(b, contact.body_b),
                  separation);
    }

    static float touching_distance(const Contact& contact) { return kTouchingPart * contact.speculative_distance; }

    void add_point(const Contact& contact, std::size_t a, std::size_t b, DVec2 normal, DVec2 arm_a, DVec2 arm_b,
                   double separation) {
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

    // Adds the contacts that the bodies now press together by more than `least` (m/s), and those with static and
    // kinematic bodies that are approached at all, at the impact or ahead. False if there are none.
    bool grow(double least) {
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

    bool may_add(ProxyPair shapes) const { return group_.points.size() < kMaxGroupPoints && !is_in_group(shapes); }

    // The shapes of earlier impacts of a body in this step may touch still. They need not have a contact.
    void add_earlier(std::uint32_t body, int last_impact, double least) {
        for (int i = last_impact; i >= 0;) {
            const Impact& earlier = scratch_.impacts[static_cast<std::size_t>(i)];
            i = body_of(earlier.shapes.a) == body ? earlier.previous_of_a : earlier.previous_of_b;
            if (may_add(earlier.shapes)) add_if_approached(ProxyPair(earlier.shapes), least);
        }
    }

    std::uint32_t body_of(std::uint32_t shape) const { return simulation_.shapes[shape].body; }

    void add_if_approached(ProxyPair shapes, double least) {
        const std::size_t before = group_.points.size();
        add_manifold(shapes);
        const bool is_bound = is_with_immovable(body_of(shapes.a), body_of(shapes.b));
        const bool takes_part = std::any_of(
            group_.points.begin() + static_cast<std::ptrdiff_t>(before), group_.points.end(),
            [&](const ImpactPoint& point) { return is_approached(point, std::max(least, point.threshold), is_bound); });
        if (takes_part) return;
        forget_points(before);
        scratch_.impacts.pop_back();
    }

    // Static and kinematic bodies bound all others: their contacts take part however slow the approach is.
    bool is_with_immovable(std::uint32_t a, std::uint32_t b) const {
        return !simulation_.bodies.is_dynamic(a) || !simulation_.bodies.is_dynamic(b);
    }

    bool is_approached(const ImpactPoint& point, double least, bool is_bound) const {
        if (is_bound) return approach_at_impact(group_, point) < 0.0 || approach_ahead(group_, point) < 0.0;
        return approach_at_impact(group_, point) < -least;
    }

    void forget_points(std::size_t from) {
        group_.points.resize(from);
        scratch_.group_points.resize(from);
    }

    bool is_in_group(ProxyPair shapes) const {
        return std::any_of(scratch_.group_points.begin(), scratch_.group_points.end(),
                           [&](const GroupPoint& own) { return own.shapes == shapes; });
    }

    // The manifold of the start of the step tells nothing of shapes that moved far since then. They collide again if
    // they bounce: with arms that are wrong, the impulse makes them spin.
    void add_contact(const Contact& contact, double least) {
        const double moved =
            length(shift_in_step(simulation_, contact.body_b) - shift_in_step(simulation_, contact.body_a));
        if (contact.restitution == 0.0f || moved <= static_cast<double>(contact.speculative_distance))
            add_touching(contact, least);
        else if (contact.manifold.point_count > 0)
            add_if_approached(contact.shapes, least);
    }

    void add_touching(const Contact& contact, double least) {
        const double threshold = std::max(least, bounce_threshold(simulation_, contact));
        const bool is_bound = is_with_immovable(contact.body_a, contact.body_b);
        if (!is_bound && !may_be_approached(contact, threshold)) return;
        const std::size_t a = member(contact.body_a), b = member(contact.body_b), before = group_.points.size();
        bool takes_part = false;
        for (int i = 0; i < contact.manifold.point_count; ++i)
            if (add_touching_point(contact, contact.manifold.points[i], a, b)) {
                scratch_.group_points.back().manifold_point = i;
                takes_part |= is_approached(group_.points.back(), threshold, is_bound);
            }
        if (!takes_part) forget_points(before);
    }

    // A quick test, which adds no members. The arms are those of the start of the step.
    bool may_be_approached(const Contact& contact, double threshold) const {
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

    Twist velocity_now(std::uint32_t body) const {
        const std::uint32_t swept = find_swept(simulation_, body);
        const auto found = std::find(scratch_.members.begin(), scratch_.members.end(), swept);
        if (swept == kNotSwept || found == scratch_.members.end()) return present_velocity(simulation_, body);
        const ImpactBody& member = group_.bodies[static_cast<std::size_t>(found - scratch_.members.begin())];
        return member.velocity + member.change;
    }

    // The largest gap of a point that takes part. Without a bounce it may close in the rest of the step: otherwise a
    // stack that lands has too many impacts for a step, and ten boxes that fall by 5 m rebound at 7 m/s.
    double largest_gap(const Contact& contact, const ImpactPoint& point) const {
        const float touching = touching_distance(contact);
        if (contact.restitution > 0.0f || has_joints(contact.body_a) || has_joints(contact.body_b)) return touching;
        const double closed = -approach_at_impact(group_, point) * (1.0 - impact_.time) * duration_;
        return std::clamp<double>(closed, touching, contact.speculative_distance);
    }

    // From the manifold that the contact had when the step began, with anchors that moved with the bodies.
    bool add_touching_point(const Contact& contact, const ManifoldPoint& point, std::size_t a, std::size_t b) {
        const DVec2 normal(contact.manifold.normal);
        const Arm arm_a = arm(contact.body_a, a, point.anchor_a), arm_b = arm(contact.body_b, b, point.anchor_b);
        const double separation = static_cast<double>(point.separation) + dot(arm_b.shift - arm_a.shift, normal);
        add_point(contact, a, b, normal, arm_a.now, arm_b.now, separation);
        if (separation <= largest_gap(contact, group_.points.back())) return true;
        forget_points(group_.points.size() - 1);
        return false;
    }

    struct Arm {
        DVec2 now, shift;  // from the centre of mass; of its end since the step began, m
    };
    Arm arm(std::uint32_t body, std::size_t index, Vec2 anchor) const {
        const BodyFrame& frame = simulation_.bodies.frames[body];
        const DVec2 before = DVec2(anchor) - DVec2(frame.center_offset);
        const std::uint32_t swept = scratch_.members[index];
        if (swept == kNotSwept) return {before, {}};
        const SinCos turn = scratch_.member_turns[index];
        const DVec2 now{turn.cos * before.x - turn.sin * before.y, turn.sin * before.x + turn.cos * before.y};
        return {now, shift_in_step(simulation_, body) + (now - before)};
    }

    // Of the impact itself, for events.
    void record_approach() {
        if (group_.points.empty()) return;
        const ImpactPoint& point = group_.points.front();
        const DVec2 at = center_now(point.a, body_of(impact_.shapes.a)) + point.arm_a;
        scratch_.impacts[first_].approach = {at, to_float(point.normal),
                                             static_cast<float>(-approach_at_impact(group_, point))};
    }

    bool has_changed() const {
        return std::any_of(group_.bodies.begin(), group_.bodies.end(),
                           [](const ImpactBody& body) { return body.change != Twist{} || body.hold != Twist{}; });
    }

    // The impact counts for its two bodies even if they part without an impulse. Other members may have no part in it.
    void apply(std::size_t index) {
        if (scratch_.members[index] == kNotSwept) return;
        if (index >= 2 && group_.bodies[index].change == Twist{} && group_.bodies[index].hold == Twist{}) return;
        SweptBody& swept = scratch_.swept[scratch_.members[index]];
        if (!simulation_.bodies.is_dynamic(swept.body)) return;
        const ImpactBody& body = group_.bodies[index];
        swept.push(body.change, duration_);
        swept.hold(body.hold, duration_);
        ++swept.impact_count;
        swept.impact_weight += weight(index);
        if (swept.impact_weight >= kMaxImpactsPerBody || has_joints(swept.body)) swept.stop();
    }

    // An impact without a bounce weighs more for its two bodies: they only come nearer to rest.
    int weight(std::size_t index) const {
        const bool bounces = !group_.points.empty() && group_.points.front().restitution > 0.0;
        return index >= 2 || bounces ? 1 : kInelasticWeight;
    }

    // Joints do not take part in impacts: a joined body goes on in the next step.
    bool has_joints(std::uint32_t body) const { return !simulation_.bodies.records[body].joints.empty(); }

    // What contacts report: the impulses of impacts count as applied in this step.
    void store_impulses() {
        for (std::size_t i = 0; i < group_.points.size(); ++i) {
            const PointImpulse applied{static_cast<float>(group_.points[i].normal_impulse),
                                       static_cast<float>(group_.points[i].tangent_impulse)};
            const GroupPoint& own = scratch_.group_points[i];
            if (own.impact >= 0)
                scratch_.impacts[static_cast<std::size_t>(own.impact)].applied[own.manifold_point] = applied;
            Contact* const contact = simulation_.contacts.find(own.shapes);
            if (!contact) continue;
            if (own.impact < 0) contact->applied[own.manifold_point] += applied;
            contact->is_touching |= applied.normal > 0.0f;
            contact->is_bouncing = false;
        }
        if (Contact* const contact = simulation_.contacts.find(impact_.shapes)) contact->is_bouncing = false;
    }

    Simulation& simulation_;
    ImpactScratch& scratch_;
    ImpactGroup& group_;
    NextImpact impact_;
    std::size_t first_;  // of this group among all impacts of the step
    double duration_;    // of the step, s
};

}  // namespace

void respond(Simulation& simulation, const NextImpact& impact) { ImpactResponse(simulation, impact).run(); }

}  // namespace tumble
