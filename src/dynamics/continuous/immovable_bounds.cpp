#include "dynamics/continuous/immovable_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "debug/check.hpp"
#include "dynamics/bodies/sweeps.hpp"
#include "dynamics/contacts/make_contact.hpp"
#include "dynamics/contacts/separation.hpp"
#include "dynamics/continuous/shape_core.hpp"
#include "dynamics/continuous/swept_bodies.hpp"
#include "dynamics/state/collision_rules.hpp"
#include "tumble/distance.hpp"
#include "tumble/manifold.hpp"

namespace tumble {

namespace {

// The core that bounds a shape's motion, as a part of its thickness.
constexpr float kBoundCore = 0.5f;

// A core that overlaps already gives way to the largest one that is out, found to this part of the shape's thickness.
// Larger: a body that is pressed into the ground creeps in.
constexpr double kCoreTolerance = 1e-4;

// The overlap at which the core touches, as a part of the shape's thickness. A body that moves by less than this part
// of its smallest extent, and has sunk in by less, needs no bound in this step.
constexpr float kBoundPart = 0.5f * (1.0f - kBoundCore);

// A body that stops at one shape may be taken by another one: at most so often, and then it stays where it is.
constexpr int kMaxStops = 4;

class MotionBound {
public:
    MotionBound(Simulation& simulation, std::uint32_t body)
        : simulation_(simulation),
          body_(body),
          moved_(simulation.bodies.solver_bodies[simulation.bodies.frames[body].solver_body]) {
        TUMBLE_CHECK(simulation.bodies.is_dynamic(body));
        TUMBLE_CHECK(simulation.bodies.frames[body].solver_body != kStaticSolverBody);
    }

    // Of a body with impacts, the chord to the last of them is bounded, and the motion after it.
    void run() {
        const std::uint32_t index = find_swept(simulation_, body_);
        const SweptBody* const swept =
            index == kNotSwept ? nullptr : &simulation_.scratch->ordered_impacts.swept[index];
        const bool has_impacts = swept && swept->impact_count > 0;
        if (!has_impacts && !may_reach_immovable(simulation_, body_)) return;
        const Sweep whole = sweep_of(simulation_.bodies, body_);
        if (!has_impacts) {
            bound(whole, 0.0, 1.0);
            return;
        }
        const Sweep last = swept->sweep;
        const Sweep before{whole.local_center, whole.start, last.start, whole.start_angle,
                           last.start_angle - whole.start_angle};
        if (!bound(before, 0.0, swept->time)) bound(last, swept->time, 1.0);
    }

private:
    struct Stop {
        double fraction = 1.0;
        DVec2 point, normal;      // world; the normal is unit, from the immovable shape
        std::uint32_t own = 0;    // the shape of the body
        std::uint32_t other = 0;  // the immovable shape
        bool is_middle = false;   // the core that touches is the middle point
    };

    // Bounds a motion between two times, fractions of the step. True if the body stops.
    bool bound(const Sweep& sweep, double from, double to) {
        sweep_ = sweep;
        from_ = from;
        to_ = to;
        for (int stops = 0; stops < kMaxStops; ++stops) {
            first_ = {};
            for (const ShapeId own : simulation_.bodies.records[body_].shapes) search(own.index);
            if (!(first_.fraction < 1.0) || (stops > 0 && is_carried())) return stops > 0;
            stop(stops + 1 == kMaxStops);
        }
        return true;
    }

    // The motion of another body during that time.
    Sweep sweep_between(std::uint32_t body) const { return part_of(sweep_of(simulation_.bodies, body), from_, to_); }

    void search(std::uint32_t own) {
        std::vector<std::uint32_t>& near = simulation_.scratch->near_shapes;
        near.clear();
        simulation_.broad.query(
            box_of_sweep(simulation_.shapes[own].shape, sweep_), [&](std::uint32_t other) { near.push_back(other); },
            ProxyLayer::fixed, ProxyLayer::kinematic);
        for (const std::uint32_t other : near) {
            const ProxyPair pair = make_pair_of(own, other);
            if (may_touch(simulation_, pair) && !crosses_chain(simulation_.chain_contacts(), pair)) meet(own, other);
        }
    }

    // Takes the first contact of a core with another shape if it is earlier; of two at one time, that of the lower one.
    void meet(std::uint32_t own, std::uint32_t other) {
        const ShapeRecord &shape = simulation_.shapes[own], &immovable = simulation_.shapes[other];
        const Sweep sweep = sweep_between(immovable.body);
        if (immovable.link &&
            is_behind(immovable.shape, *immovable.link, pose_at(sweep, 0.0), shape.shape, pose_at(sweep_, 0.0)))
            return;
        float part = kBoundCore;
        CastResult hit = time_of_impact(immovable.shape, sweep, core_of(shape, part), sweep_);
        if (hit.status == CastStatus::overlapping) {
            part = part_outside(shape, immovable, sweep);
            hit = time_of_impact(immovable.shape, sweep, core_of(shape, part), sweep_);
        }
        take(hit, own, other, part == 0.0f);
    }

    // The part of the largest core of the shape that is out of the other one when the motion begins, by bisection; 0 if
    // there is none. A core that is out by rounding alone would overlap in the search.
    float part_outside(const ShapeRecord& shape, const ShapeRecord& immovable, const Sweep& sweep) const {
        const Pose pose = pose_at(sweep_, 0.0), other_pose = pose_at(sweep, 0.0);
        const double least = 0.5 * kCoreTolerance * static_cast<double>(shape.smaller_extent);
        float out = 0.0f, in = kBoundCore;
        while (static_cast<double>(in - out) > kCoreTolerance) {
            const float part = 0.5f * (out + in);
            const DistanceResult found = distance(immovable.shape, other_pose, core_of(shape, part), pose);
            (static_cast<double>(found.distance) > least ? out : in) = part;
        }
        return out;
    }

    void take(const CastResult& hit, std::uint32_t own, std::uint32_t other, bool is_middle) {
        if (hit.status == CastStatus::hit && std::tie(hit.fraction, other) < std::tie(first_.fraction, first_.other))
            first_ = {hit.fraction, hit.point, hit.normal, own, other, is_middle};
    }

    // True if the body moves as the shape that it meets, up to rounding: it touches that all the time.
    bool is_carried() const {
        const double time = from_ + first_.fraction * (to_ - from_);
        const DVec2 chord = sweep_.end - sweep_.start, arm = first_.point - (sweep_.start + first_.fraction * chord);
        const DVec2 path = chord + sweep_.turn * perp(arm) - (to_ - from_) * surface_path(time);
        return std::abs(dot(path, first_.normal)) <= tolerance();
    }

    double tolerance() const {  // m
        return kCoreTolerance * static_cast<double>(simulation_.bodies.records[body_].motion.smallest_extent);
    }

    // The body stays where it stops, but is taken along the normal by a kinematic body.
    void stop(bool is_last) {
        TUMBLE_CHECK(first_.fraction >= 0.0);
        TUMBLE_CHECK(first_.fraction < 1.0);
        const double time = from_ + first_.fraction * (to_ - from_), along = dot(surface_path(time), first_.normal);
        const DVec2 taken = is_last ? DVec2{} : std::max((1.0 - time) * along, 0.0) * first_.normal;
        to_ = 1.0;
        sweep_.end = sweep_.start + first_.fraction * (sweep_.end - sweep_.start) +
                     DVec2(allowed(moved_.flags, to_float(taken)));
        if (is_last || !turns_on()) sweep_.turn *= first_.fraction;
        const BodyFrame& frame = simulation_.bodies.frames[body_];
        moved_.delta_position = to_float(sweep_.end - frame.center);
        moved_.delta_rotation = make_rotation(sweep_.start_angle + sweep_.turn - angle(frame.pose.rotation));
        const double speed =
            dot(DVec2(moved_.velocity), first_.normal) - along / static_cast<double>(simulation_.settings.duration);
        if (speed < 0.0 && !bounces()) moved_.velocity -= allowed(moved_.flags, to_float(speed * first_.normal));
    }

    // A body that bounces keeps its velocity: the next step reflects it.
    bool bounces() const {
        const ProxyPair pair = make_pair_of(first_.own, first_.other);
        return make_contact(pair, simulation_.shapes, simulation_.settings.tuning).restitution > 0.0f;
    }

    // True if the rotation leaves the touching point where it is: the middle of a shape that is half inside. To stop
    // that rotation too would hold a body that spins there for ever.
    bool turns_on() const {
        const DVec2 arm = first_.point - (sweep_.start + first_.fraction * (sweep_.end - sweep_.start));
        return first_.is_middle && length(sweep_.turn * arm) <= tolerance();
    }

    // The velocity of the immovable shape's point at a time, times the whole step, m.
    DVec2 surface_path(double time) const {
        const Sweep sweep = sweep_of(simulation_.bodies, simulation_.shapes[first_.other].body);
        const DVec2 path = sweep.end - sweep.start, center = sweep.start + time * path;
        return path + sweep.turn * perp(first_.point - center);
    }

    Simulation& simulation_;
    std::uint32_t body_;
    SolverBody& moved_;
    Sweep sweep_;                   // the motion that is bounded
    double from_ = 0.0, to_ = 1.0;  // when it begins and ends, fractions of the step
    Stop first_;
};

// True if the moving shape of a ground contact has sunk into the ground when the step begins or ends: the point of a
// disc that rotates leaves the ground though the disc does not.
bool is_sunk(const Simulation& simulation, GroundContact ground) {
    const Contact& contact = simulation.contacts.all()[ground.contact];
    const float depth = kBoundPart * simulation.shapes[ground.moving_shape].smaller_extent;
    for (int i = 0; i < contact.manifold.point_count; ++i) {
        const ManifoldPoint& point = contact.manifold.points[i];
        if (std::min(point.separation, separation_at_end(contact, point, simulation.bodies)) < -depth) return true;
    }
    return false;
}

// The bodies that may need a bound, each once.
void find_bounded(Simulation& simulation) {
    const BodyStore& bodies = simulation.bodies;
    std::vector<std::uint32_t>& bounded = simulation.scratch->ordered_impacts.bounded_bodies;
    bounded.clear();
    for (std::size_t i = 1; i < bodies.moving.size(); ++i) {
        const BodyMotion& motion = bodies.moving[i].motion;
        const SolverBody& body = bodies.solver_bodies[i];
        if ((body.flags & kDynamicBody) && displacement_in_step(body, motion) > kBoundPart * motion.smallest_extent)
            bounded.push_back(bodies.moving[i].body);
    }
    for (const GroundContact ground : simulation.scratch->ground_contacts) {
        const std::uint32_t body = simulation.shapes[ground.moving_shape].body;
        if (!bodies.is_asleep(body) && is_sunk(simulation, ground)) bounded.push_back(body);
    }
    std::sort(bounded.begin(), bounded.end());
    bounded.erase(std::unique(bounded.begin(), bounded.end()), bounded.end());
}

}  // namespace

void keep_out_of_immovable(Simulation& simulation) {
    if (!simulation.settings.continuous) return;
    find_bounded(simulation);
    for (const std::uint32_t body : simulation.scratch->ordered_impacts.bounded_bodies)
        MotionBound(simulation, body).run();
}

}  // namespace tumble
