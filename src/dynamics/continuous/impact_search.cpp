#include "dynamics/continuous/impact_search.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "debug/check.hpp"
#include "dynamics/bodies/sweeps.hpp"
#include "dynamics/contacts/separation.hpp"
#include "dynamics/continuous/contact_lists.hpp"
#include "dynamics/continuous/swept_bodies.hpp"
#include "dynamics/continuous/swept_pair.hpp"
#include "dynamics/state/collision_rules.hpp"

namespace tumble {

namespace {

// An angle below an eighth of a turn, over its sine, is at most this.
constexpr double kAnglePerSine = 1.12;

// True if the farthest point of a body is farther than `most` (m) from where its free motion would have taken it. The
// sum of the turns bounds their difference: few bodies need an arc tangent.
bool deviates(const SolverBody& body, const FreeMotion& free, const BodyMotion& motion, float most) {
    const float off_path = length(body.delta_position - free.path);
    const float turns = angle_bound(body.delta_rotation) + std::abs(free.turn);
    if (off_path + turns * motion.reach <= most) return false;
    const double turn = angle(body.delta_rotation) - static_cast<double>(free.turn);
    return off_path + std::abs(static_cast<float>(turn)) * motion.reach > most;
}

bool moves_far_in_step(const Simulation& simulation, std::size_t index) {
    const BodyMotion& motion = simulation.bodies.moving[index].motion;
    return displacement_in_step(simulation.bodies.solver_bodies[index], motion) >
           kContinuousPart * motion.smallest_extent;
}

// Only the impacts of free motions have become contacts.
bool leaves_foreseen_motion(const Simulation& simulation, std::size_t index) {
    const BodyMotion& motion = simulation.bodies.moving[index].motion;
    const std::vector<FreeMotion>& foreseen = simulation.scratch->free_motions;
    return index >= foreseen.size() || deviates(simulation.bodies.solver_bodies[index], foreseen[index], motion,
                                                kContinuousPart * motion.smallest_extent);
}

// True if the solver has left two bodies with an overlap of more than `deep` (m), although their points moved by more
// than `least` (m) against each other.
bool is_left_overlapping(const Contact& contact, float deep, float least, const BodyStore& bodies) {
    for (int i = 0; i < contact.manifold.point_count; ++i) {
        const ManifoldPoint& point = contact.manifold.points[i];
        if (separation_at_end(contact, point, bodies) < -deep &&
            length_sq(relative_shift(contact, point, bodies)) > least * least)
            return true;
    }
    return false;
}

// Continuous collision leaves two shapes to the solver if they move by no more than this against each other, m. Two
// dynamic bodies then overlap at most to the middle of the smaller shape, and the solver parts them in the next step.
float least_displacement(const Simulation& simulation, std::uint32_t a, std::uint32_t b) {
    const ShapeRecord &shape_a = simulation.shapes[a], &shape_b = simulation.shapes[b];
    const bool are_dynamic = simulation.bodies.is_dynamic(shape_a.body) && simulation.bodies.is_dynamic(shape_b.body);
    return are_dynamic ? kContinuousPart * smaller_extent(shape_a, shape_b) : 0.0f;
}

// True if two points that move along straight lines come as near as `distance`.
bool come_near(DVec2 offset, DVec2 path, double distance) {
    const double square = length_sq(path);
    const double nearest = square > 0.0 ? std::clamp(-dot(offset, path) / square, 0.0, 1.0) : 0.0;
    return length_sq(offset + nearest * path) <= distance * distance;
}

// A pair that needs longer than this part of a step from its chords to its parabolas only grazes.
constexpr double kLongestDelay = 0.1;

// One of the two bodies of a pair, from the time at which both have their motion ahead.
struct Side {
    const ShapeRecord& shape;
    Sweep sweep;
    double reach;  // of the shape from the centre of mass, m
};

// The motion of a body from a time until the step ends.
struct MotionAhead {
    DVec2 center;      // at that time, m
    DVec2 path;        // of the centre of mass, m
    double arc = 0.0;  // a bound of the arc of the farthest point, m
};

class ImpactSearch {
public:
    ImpactSearch(Simulation& simulation, std::uint32_t swept)
        : simulation_(simulation), scratch_(simulation.scratch->ordered_impacts), index_(swept) {}

    void run() {
        forget_next_impact(simulation_, index_);
        NextImpact& next = scratch_.next[index_];
        if (self().has_stopped || !(self().time < 1.0)) return;
        if (self().is_off_course)
            for (const ShapeId own : simulation_.bodies.records[self().body].shapes) search(own.index);
        else
            search_bounces();
        if (next.time >= 1.0) return;
        scratch_.queue.push_back({next.time, next.shapes, index_, next.version});
        std::push_heap(scratch_.queue.begin(), scratch_.queue.end(), std::greater<>{});
    }

private:
    const SweptBody& self() const { return scratch_.swept[index_]; }

    void search(std::uint32_t own) {
        const ShapeRecord& shape = simulation_.shapes[own];
        const Aabb box = box_of_sweep(shape.shape, self().sweep);
        std::vector<std::uint32_t>& near = scratch_.near_shapes;
        near.clear();
        simulation_.broad.query(box, [&](std::uint32_t other) { near.push_back(other); });
        for (const std::uint32_t other : near)
            if (find_swept(simulation_, simulation_.shapes[other].body) == kNotSwept) consider(own, other, nullptr);
        near.clear();
        scratch_.tree.query(box, [&](std::uint32_t swept) { near.push_back(swept); });
        for (const std::uint32_t swept : near)
            if (swept != index_ && comes_near(scratch_.swept[swept]))
                for (const ShapeId other : simulation_.bodies.records[scratch_.swept[swept].body].shapes)
                    consider(own, other.index, &scratch_.swept[swept]);
    }

    // The solver keeps a body that is on its course apart from all others.
    void search_bounces() {
        for (const BodyContact& contact : contacts_of(simulation_, self().body)) {
            if (!simulation_.contacts.all()[contact.index].is_bouncing) continue;
            const bool is_first = simulation_.shapes[contact.shapes.a].body == self().body;
            const std::uint32_t own = is_first ? contact.shapes.a : contact.shapes.b;
            const std::uint32_t other = is_first ? contact.shapes.b : contact.shapes.a;
            const std::uint32_t partner = find_swept(simulation_, simulation_.shapes[other].body);
            consider(own, other, partner == kNotSwept ? nullptr : &scratch_.swept[partner]);
        }
    }

    // The discs around the two bodies meet.
    bool comes_near(const SweptBody& other) const {
        const double from = std::max(self().time, other.time);
        const Sweep a = self().sweep_from(from), b = other.sweep_from(from);
        const double distance = static_cast<double>(reach(self().body)) + static_cast<double>(reach(other.body));
        return come_near(b.start - a.start, (b.end - b.start) - (a.end - a.start), distance);
    }
    float reach(std::uint32_t body) const { return simulation_.bodies.records[body].motion.reach; }

    // `partner` is the body of the other shape, if it is swept.
    void consider(std::uint32_t own, std::uint32_t other, const SweptBody* partner) {
        const ProxyPair pair = make_pair_of(own, other);
        if (is_sensor(own) != is_sensor(other)) {
            if (self().impact_count == 0) simulation_.scratch->sensor_crossings.push_back(pair);
            return;
        }
        const double from = partner ? std::max(self().time, partner->time) : self().time;
        const MotionAhead own_motion = motion_ahead(self(), from);
        const MotionAhead motion = partner ? motion_ahead(*partner, from) : motion_ahead(shape(other).body, from);
        const DVec2 path = motion.path - own_motion.path;
        if (!come_near(motion.center - own_motion.center, path, reach_of(own) + reach_of(other))) return;
        const Contact* const contact = find_contact(simulation_, self().body, pair);
        const bool bounces = contact && contact->is_bouncing;
        if (!bounces && !move_far(own, other, length(path) + own_motion.arc + motion.arc)) return;
        if (!may_have_impact(pair)) return;
        const Side a = side(own, from), b = side(other, from);
        if (crosses_chain(simulation_.chain_contacts(), pair)) return;
        if (bounces && contact->is_struck) return take(from, pair, partner, {});
        PairImpact impact = bounces ? find_bounce(a.shape, a.sweep, b.shape, b.sweep, inset(a, b))
                                    : find_impact(a.shape, a.sweep, b.shape, b.sweep, inset(a, b), is_pushed(contact));
        if (!(impact.fraction < 1.0)) return;
        double time = from + impact.fraction * (1.0 - from);
        time = std::max(from, time + delay(time, (1.0 / (1.0 - from)) * path, impact.normal, partner));
        if (own == pair.a) impact.normal = -impact.normal;
        if (impact.touched && self().impact_count > 0) time = std::max(time, from + rest_after_impact(a, b, path));
        if (time < 1.0) take(time, pair, partner, impact);
    }

    bool is_sensor(std::uint32_t shape) const { return simulation_.shapes[shape].is_sensor; }

    // How much later than their chords two bodies meet on their parabolas: a step of Newton's method. `speed` is that
    // of the other body along its chord, `normal` points from it to the moving one. In parts of the step.
    double delay(double time, DVec2 speed, DVec2 normal, const SweptBody* partner) const {
        const double duration = static_cast<double>(simulation_.settings.duration), approach = dot(speed, normal);
        const DVec2 bulge = self().bulge(time, duration) - (partner ? partner->bulge(time, duration) : DVec2{});
        const double gap = dot(bulge, normal);
        return std::abs(gap) < approach * kLongestDelay ? gap / approach : 0.0;
    }

    // For how long two shapes that touch after an impact are left alone, as a fraction of the step: until they may have
    // sunk in by the inset. The weight of the body's impacts makes it longer, so that a ball driven by a turning paddle
    // has few of them, but the shapes cannot pass through each other: they sink in by the smaller extent at most. Half
    // of it makes fast bodies stop sooner, so that others pass through them. Two segments have no thickness to sink in
    // by: they are left alone for the longest time.
    double rest_after_impact(const Side& a, const Side& b, DVec2 path) const {
        const double moved = length(path) + std::abs(a.sweep.turn) * a.reach + std::abs(b.sweep.turn) * b.reach;
        const double ahead = 1.0 - self().time;
        const double deepest = static_cast<double>(smaller_extent(a.shape, b.shape));
        const double sink =
            std::min(static_cast<double>(inset(a, b)) * (1 << std::min(self().impact_weight / 4, 16)), deepest);
        return moved > 0.0 && sink > 0.0 ? std::min(kLongestRest, ahead * sink / moved) : kLongestRest;
    }

    // At least one of the bodies can be pushed.
    bool may_have_impact(ProxyPair pair) const {
        return (can_be_pushed(simulation_.shapes[pair.a].body) || can_be_pushed(simulation_.shapes[pair.b].body)) &&
               may_touch(simulation_, pair);
    }
    bool can_be_pushed(std::uint32_t body) const {
        if (!simulation_.bodies.is_dynamic(body)) return false;
        const std::uint32_t swept = find_swept(simulation_, body);
        return swept == kNotSwept || !scratch_.swept[swept].has_stopped;
    }

    Side side(std::uint32_t shape, double from) const {
        const ShapeRecord& record = simulation_.shapes[shape];
        const std::uint32_t swept = find_swept(simulation_, record.body);
        const Sweep sweep = swept == kNotSwept ? part_of(sweep_of(simulation_.bodies, record.body), from, 1.0)
                                               : scratch_.swept[swept].sweep_from(from);
        return {record, sweep, farthest_distance(record.shape, sweep.local_center)};
    }

    const ShapeRecord& shape(std::uint32_t index) const { return simulation_.shapes[index]; }

    // Of a shape from the centre of mass of its body, m.
    double reach_of(std::uint32_t index) const {
        return farthest_distance(shape(index).shape, simulation_.bodies.records[shape(index).body].mass.center);
    }

    bool move_far(std::uint32_t own, std::uint32_t other, double moved) const {
        return moved > static_cast<double>(least_displacement(simulation_, own, other));
    }

    MotionAhead motion_ahead(const SweptBody& swept, double from) const {
        const double passed = from > swept.time ? (from - swept.time) / (1.0 - swept.time) : 0.0;
        const DVec2 path = swept.sweep.end - swept.sweep.start;
        return {swept.sweep.start + passed * path, (1.0 - passed) * path,
                (1.0 - passed) * std::abs(swept.sweep.turn) * static_cast<double>(reach(swept.body))};
    }
    MotionAhead motion_ahead(std::uint32_t body, double from) const {
        const BodyFrame& frame = simulation_.bodies.frames[body];
        const SolverBody& moved = simulation_.bodies.solver_bodies[frame.solver_body];
        const double turn = kAnglePerSine * std::abs(static_cast<double>(moved.delta_rotation.s));
        return {frame.center + from * DVec2(moved.delta_position), (1.0 - from) * DVec2(moved.delta_position),
                (1.0 - from) * turn * static_cast<double>(reach(body))};
    }

    float inset(const Side& a, const Side& b) const {
        return kContinuousInset * simulation_.settings.tuning.speculative_distance(smaller_extent(a.shape, b.shape));
    }

    // True if the solver pushed the two shapes apart in this step.
    static bool is_pushed(const Contact* contact) {
        return contact && (contact->applied[0].normal > 0.0f || contact->applied[1].normal > 0.0f);
    }

    // The first impact counts; of two at one time that of the first pair.
    void take(double time, ProxyPair pair, const SweptBody* partner, const PairImpact& impact) {
        NextImpact& next = scratch_.next[index_];
        if (time > next.time || (time == next.time && !(pair < next.shapes))) return;
        next.time = time;
        next.shapes = pair;
        next.partner_impacts = partner ? partner->impact_count : 0;
        next.point = impact.point;
        next.normal = impact.normal;
    }

    Simulation& simulation_;
    ImpactScratch& scratch_;
    std::uint32_t index_;
};

bool has_far_body(const Simulation& simulation, const Contact& contact) {
    const BodyStore& bodies = simulation.bodies;
    return moves_far_in_step(simulation, bodies.frames[contact.body_a].solver_body) ||
           moves_far_in_step(simulation, bodies.frames[contact.body_b].solver_body);
}

// A body in free flight is not swept. Its boxes cover its path, so that it has a contact with each sensor near that.
bool may_cross_sensor(const Simulation& simulation, const Contact& contact) {
    return simulation.settings.continuous && contact.kind != ContactKind::solid && has_far_body(simulation, contact);
}

bool overlaps_at_speed(const Simulation& simulation, const Contact& contact) {
    if (!simulation.settings.continuous || contact.manifold.point_count == 0 || !has_far_body(simulation, contact))
        return false;
    const float least = least_displacement(simulation, contact.shapes.a, contact.shapes.b);
    const ShapeStore& shapes = simulation.shapes;
    const float extent = smaller_extent(shapes[contact.shapes.a], shapes[contact.shapes.b]);
    const float deep = simulation.settings.tuning.speculative_distance(extent);
    return is_left_overlapping(contact, deep, least, simulation.bodies);
}

void sweep_on_course(Simulation& simulation, std::uint32_t body) { sweep_body(simulation, body); }

void sweep_off_course(Simulation& simulation, std::uint32_t body) {
    const std::uint32_t swept = sweep_body(simulation, body);
    simulation.scratch->ordered_impacts.swept[swept].is_off_course = true;
}

}  // namespace

void find_fast_bodies(Simulation& simulation) {
    const BodyStore& bodies = simulation.bodies;
    bool may_concern_contacts = simulation.scratch->ordered_impacts.bounces.has_candidates;
    if (simulation.settings.continuous) {
        for (std::size_t i = 1; i < bodies.moving.size(); ++i) {
            if (!moves_far_in_step(simulation, i)) continue;
            may_concern_contacts = true;
            if (leaves_foreseen_motion(simulation, i)) sweep_off_course(simulation, bodies.moving[i].body);
        }
    }
    if (!may_concern_contacts) return;
    for (const Contact& contact : simulation.contacts.all()) {
        if (may_cross_sensor(simulation, contact)) simulation.scratch->sensor_crossings.push_back(contact.shapes);
        const bool overlaps = overlaps_at_speed(simulation, contact);
        if (!contact.is_bouncing && !overlaps) continue;
        for (const std::uint32_t body : {contact.body_a, contact.body_b})
            if (bodies.frames[body].solver_body != kStaticSolverBody)
                overlaps ? sweep_off_course(simulation, body) : sweep_on_course(simulation, body);
    }
}

void find_next_impact(Simulation& simulation, std::uint32_t swept) { ImpactSearch(simulation, swept).run(); }

void forget_next_impact(Simulation& simulation, std::uint32_t swept) {
    NextImpact& next = simulation.scratch->ordered_impacts.next[swept];
    const std::uint32_t version = next.version + 1;
    next = {};
    next.version = version;
}

void note_course(Simulation& simulation, std::uint32_t swept) {
    SweptBody& body = simulation.scratch->ordered_impacts.swept[swept];
    const Sweep solved = sweep_of(simulation.bodies, body.body);
    const double turn = (body.sweep.start_angle + body.sweep.turn) - (solved.start_angle + solved.turn);
    const BodyMotion& motion = simulation.bodies.records[body.body].motion;
    const double deviation = length(body.sweep.end - solved.end) + std::abs(turn) * static_cast<double>(motion.reach);
    body.is_off_course |= deviation > static_cast<double>(kContinuousPart * motion.smallest_extent);
}

bool moves_far(const Simulation& simulation, std::uint32_t swept) {
    const SweptBody& body = simulation.scratch->ordered_impacts.swept[swept];
    const BodyMotion& motion = simulation.bodies.records[body.body].motion;
    const double moved =
        length(body.sweep.end - body.sweep.start) + std::abs(body.sweep.turn) * static_cast<double>(motion.reach);
    return moved > static_cast<double>(kContinuousPart * motion.smallest_extent);
}

}  // namespace tumble
