// The stages of a step, in the order in which it runs them.
#include <chrono>

#include "dynamics/bodies/integrate.hpp"
#include "dynamics/stages/chain_passes.hpp"
#include "dynamics/stages/continuous.hpp"
#include "dynamics/stages/events.hpp"
#include "dynamics/stages/seams.hpp"
#include "dynamics/stages/sensor_passes.hpp"
#include "dynamics/stages/sleep.hpp"
#include "dynamics/state/simulation.hpp"

namespace tumble {

namespace {

// Reads the clock once between two stages.
class StageClock {
public:
    // Adds the time since the last call, or since the start, to a stage.
    void stop(double& stage_ms) {
        const Clock::time_point now = Clock::now();
        stage_ms += milliseconds(now - last_);
        last_ = now;
    }
    double total() const { return milliseconds(last_ - start_); }

private:
    using Clock = std::chrono::steady_clock;
    static double milliseconds(Clock::duration time) { return std::chrono::duration<double, std::milli>(time).count(); }

    Clock::time_point start_ = Clock::now();
    Clock::time_point last_ = start_;
};

SpeedLimits speed_limits(const Simulation& simulation) {
    return {simulation.settings.tuning.max_speed, kMaxRotation / simulation.settings.duration,
            kMaxFastRotation / simulation.settings.substep_duration()};
}

JointContext joint_context(const Simulation& simulation) {
    const float h = simulation.settings.substep_duration();
    return {h, 1.0f / h, joint_softness(simulation.settings.tuning, h)};
}

bool joined_without_contact(const Simulation& simulation, std::uint32_t body_a, std::uint32_t body_b) {
    for (const JointId id : simulation.bodies.fewer_joints(body_a, body_b)) {
        const JointDef& def = simulation.joints.def(id);
        const std::uint32_t a = joint_body_a(def).index, b = joint_body_b(def).index;
        const bool are_its_ends = (a == body_a && b == body_b) || (a == body_b && b == body_a);
        if (are_its_ends && !collides_connected(def)) return true;
    }
    return false;
}

void collide_and_count(Simulation& simulation, Contact& contact) {
    const bool was_apart = contact.came_from == LinkSide::apart;
    const bool in_full = collide_contact(contact, simulation.bodies, simulation.shapes, simulation.settings.duration);
    if (was_apart && contact.came_from != LinkSide::apart) keep_side(simulation, contact);
    simulation.passes.now |= contact.came_from == LinkSide::solid;
    ++simulation.collided.asked;
    if (!in_full) return;
    ++simulation.collided.full;
    simulation.collided.iterations += contact.cache.iterations;
}

}  // namespace

void step(Simulation& simulation) {
    StageTimes& ms = simulation.times = StageTimes{};
    StageClock clock;
    clear(simulation.events);
    find_pairs(simulation);
    clock.stop(ms.pairs);
    simulation.collided = {};
    collide_pairs(simulation);
    collide_woken(simulation);
    smooth_seams(simulation);
    clock.stop(ms.collide);
    prepare_constraints(simulation);
    clock.stop(ms.prepare);
    for (int i = 0; i < simulation.settings.substeps; ++i) run_substep(simulation);
    bounce(simulation);
    store_results(simulation);
    forget_throws(simulation);
    clock.stop(ms.solve);
    stop_at_impacts(simulation);
    find_sensor_passes(simulation);
    finalize_poses(simulation.bodies, speed_limits(simulation));
    clock.stop(ms.continuous);
    if (find_diverged(simulation.bodies) == kNoBody) {
        update_proxies(simulation);
        clock.stop(ms.proxies);
        find_pairs(simulation);
        clock.stop(ms.pairs);
        report_events(simulation);
        clock.stop(ms.events);
        fall_asleep(simulation);
        clock.stop(ms.sleep);
    }
    ms.step = clock.total();
}

bool may_touch(const Simulation& simulation, ProxyPair shapes) {
    const ShapeRecord& a = simulation.shapes[shapes.a];
    const ShapeRecord& b = simulation.shapes[shapes.b];
    return a.body != b.body && !a.is_sensor && !b.is_sensor && may_meet(a.filter, b.filter) &&
           !joined_without_contact(simulation, a.body, b.body);
}

// Type and rest do not count: what falls asleep, or stops, still touches what it leans on.
bool is_over(const Simulation& simulation, const Contact& contact) {
    return !simulation.broad.overlap(contact.shapes) ||
           (simulation.filters_changed && !may_touch(simulation, contact.shapes));
}

bool may_collide(const Simulation& simulation, ProxyPair shapes) {
    const ShapeRecord& a = simulation.shapes[shapes.a];
    const ShapeRecord& b = simulation.shapes[shapes.b];
    if (!simulation.is_live(shapes)) return false;
    const BodyStore& bodies = simulation.bodies;
    if (a.is_sensor != b.is_sensor) {
        const bool both_static =
            bodies.frames[a.body].type == BodyType::static_body && bodies.frames[b.body].type == BodyType::static_body;
        return a.body != b.body && !both_static && may_meet(a.filter, b.filter);
    }
    const bool can_give_way = bodies.is_dynamic(a.body) || bodies.is_dynamic(b.body);
    const bool can_come_near = bodies.is_active(a.body) || bodies.is_active(b.body);
    return can_give_way && can_come_near && may_touch(simulation, shapes);
}

// Once for what the caller has changed, and once for what the step has moved: nobody enters a sensor unseen. New pairs
// come from boxes that have moved; pairs go when their boxes have parted, which only such a box can cause.
void find_pairs(Simulation& simulation) {
    simulation.contacts.merge_woken();
    const bool moved = simulation.broad.has_moved();
    const std::vector<ProxyPair>& new_pairs =
        simulation.broad.find_new_pairs([&](ProxyPair pair) { return may_collide(simulation, pair); });
    if (!moved && !simulation.shapes.has_destroyed() && !simulation.filters_changed) return;
    simulation.contacts.update(new_pairs, simulation.shapes, simulation.settings.tuning, [&](Contact& contact) {
        const bool keep = simulation.broad.overlap(contact.shapes) &&
                          !(simulation.filters_changed && !may_collide(simulation, contact.shapes));
        if (!keep) {
            report_parting(simulation, contact);
            simulation.broad.remove_pair(contact.shapes);
        }
        return keep;
    });
    simulation.shapes.forget_destroyed();
    simulation.filters_changed = false;
}

void collide_pairs(Simulation& simulation) {
    simulation.passes = {.before = simulation.passes.now};
    for (Contact& contact : simulation.contacts.all())
        if (contact.kind == ContactKind::solid) collide_and_count(simulation, contact);
}

// What is touched wakes before it is solved, and may touch the next.
void collide_woken(Simulation& simulation) {
    while (wake_touched(simulation)) {
        find_pairs(simulation);
        for (Contact& contact : simulation.contacts.all())
            if (contact.is_new && contact.kind == ContactKind::solid) collide_and_count(simulation, contact);
    }
}

void prepare_constraints(Simulation& simulation) {
    simulation.graph.build(simulation.contacts.all(), simulation.bodies);
    prepare_contacts(simulation.contacts.all(), simulation.bodies, simulation.graph, simulation.settings.tuning,
                     simulation.settings.gravity, simulation.settings.substep_duration(), simulation.blocks);
    simulation.joints.prepare(simulation.bodies);
}

void run_substep(Simulation& simulation) {
    const JointContext context = joint_context(simulation);
    const std::span<SolverBody> bodies = simulation.bodies.solver_bodies;
    integrate_velocities(simulation.bodies, simulation.settings.gravity, context.h, speed_limits(simulation));
    simulation.joints.warm_start(bodies);
    warm_start_contacts(simulation.blocks, bodies);
    simulation.joints.solve(context, true, bodies);
    solve_contacts(simulation.blocks, bodies, context.inv_h, simulation.settings.tuning.push_out_speed);
    integrate_positions(simulation.bodies, context.h, speed_limits(simulation));
    simulation.joints.solve(context, false, bodies);
    relax_contacts(simulation.blocks, bodies, context.inv_h);
}

void bounce(Simulation& simulation) {
    apply_restitution(simulation.blocks, simulation.bodies.solver_bodies,
                      simulation.settings.tuning.restitution_threshold, simulation.settings.substep_duration(),
                      simulation.given_work);
}

void store_results(Simulation& simulation) {
    store_impulses(simulation.blocks, simulation.graph, simulation.contacts.all());
    simulation.joints.store(joint_context(simulation));
    simulation.events.broken_joints = simulation.joints.broken();
}

// Joints that contradict each other, or pull a body against what it was stopped at, push the harder the longer they do.
// Their impulses cancel only as long as nothing turns, and grow without bound (a hundredfold a step) once they throw
// their bodies about: those are not carried over.
void forget_throws(Simulation& simulation) {
    const BodyStore& bodies = simulation.bodies;
    for (std::size_t i = 1; i < bodies.solver_bodies.size(); ++i)
        if (bodies.solver_bodies[i].flags & kThrownBody)
            for (const JointId id : bodies.records[bodies.moving[i].body].joints) simulation.joints.forget_impulses(id);
}

void update_proxies(Simulation& simulation) {
    for (std::size_t i = 1; i < simulation.bodies.moving.size(); ++i) {
        const std::uint32_t body = simulation.bodies.moving[i].body;
        for (const ShapeId shape : simulation.bodies.records[body].shapes)
            simulation.shapes.update_proxy(shape.index, simulation.bodies.frames[body].pose, simulation.settings.tuning,
                                           simulation.broad);
    }
}

}  // namespace tumble
