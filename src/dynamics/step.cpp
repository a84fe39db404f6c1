#include "dynamics/step.hpp"

#include <chrono>
#include <cmath>

#include "debug/check.hpp"
#include "dynamics/bodies/divergence.hpp"
#include "dynamics/bodies/final_poses.hpp"
#include "dynamics/bodies/integrate.hpp"
#include "dynamics/contacts/collide_contact.hpp"
#include "dynamics/contacts/contact_block.hpp"
#include "dynamics/stages/bounces.hpp"
#include "dynamics/stages/continuous.hpp"
#include "dynamics/stages/events.hpp"
#include "dynamics/stages/free_flight.hpp"
#include "dynamics/stages/ordered_impacts.hpp"
#include "dynamics/stages/seams.hpp"
#include "dynamics/stages/sensor_crossings.hpp"
#include "dynamics/stages/sleep.hpp"
#include "dynamics/state/collision_rules.hpp"

namespace tumble {

namespace {

// Measures stages with one reading of the clock between two of them.
class StageClock {
public:
    // Adds the time since the last call, or since the start, to a stage, ms.
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

SpeedLimits speed_limits(const Simulation& simulation) { return simulation.settings.speed_limits(); }

FrictionBound friction_bound(const Simulation& simulation) {
    return simulation.settings.orders_impacts() ? FrictionBound::rigid : FrictionBound::biased;
}

JointContext joint_context(const Simulation& simulation) {
    const float h = simulation.settings.substep_duration();
    const bool is_direct = simulation.settings.joints == JointSolver::direct;
    return {h, 1.0f / h, joint_softness(simulation.settings.tuning, h), !is_direct};
}

StepAhead step_ahead(const Simulation& simulation) {
    const StepSettings& settings = simulation.settings;
    return {settings.duration, settings.gravity, simulation.scratch.free_motions, settings.orders_impacts()};
}

void collide_and_count(Simulation& simulation, Contact& contact) {
    const bool was_apart = contact.chain_state == ChainState::apart;
    const StepAhead ahead = step_ahead(simulation);
    const bool in_full = collide_contact(contact, simulation.bodies, simulation.shapes, ahead);
    if (ahead.predicts) note_bounce(simulation, contact);
    if (was_apart) follow_neighbors(simulation.chain_contacts(), contact);
    simulation.chain_crossings.now |= contact.chain_state == ChainState::crossing;
    ++simulation.report.collided.pairs;
    if (!in_full) return;
    ++simulation.report.collided.full;
    simulation.report.collided.iterations += contact.cache.iterations;
}

void update_boxes(Simulation& simulation, const MovingBody& moving, const FreeMotion& ahead) {
    for (const ShapeId shape : simulation.bodies.records[moving.body].shapes)
        simulation.shapes.update_proxy(shape.index, simulation.bodies.frames[moving.body].pose, ahead,
                                       simulation.settings.tuning, simulation.broad);
}

}  // namespace

void step(Simulation& simulation) {
    StageTimes& ms = simulation.report.times = StageTimes{};
    StageClock clock;
    clear(simulation.events);
    if (simulation.settings.orders_impacts()) cover_free_motions(simulation);
    find_pairs(simulation);
    clock.stop(ms.pairs);
    simulation.report.collided = {};
    collide_pairs(simulation);
    collide_woken(simulation);
    smooth_seams(simulation);
    if (simulation.settings.orders_impacts()) find_bounces(simulation);
    clock.stop(ms.collide);
    prepare_constraints(simulation);
    clock.stop(ms.prepare);
    if (simulation.settings.orders_impacts()) begin_flight(simulation);
    for (int i = 0; i < simulation.settings.substeps; ++i) run_substep(simulation);
    if (!simulation.settings.orders_impacts()) bounce(simulation);
    store_results(simulation);
    forget_clamped_impulses(simulation);
    clock.stop(ms.solve);
    collide_continuously(simulation);
    find_sensor_crossings(simulation);
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

// The boxes of a body that moves less than its speculative distance have margin enough.
void cover_free_motions(Simulation& simulation) {
    const StepSettings& settings = simulation.settings;
    const BodyStore& bodies = simulation.bodies;
    std::vector<FreeMotion>& motions = simulation.scratch.free_motions;
    motions.resize(bodies.moving.size());
    for (std::size_t i = 1; i < motions.size(); ++i) {
        const BodyMotion& body = bodies.moving[i].motion;
        motions[i] = bodies.free_motion(static_cast<std::uint32_t>(i), settings.gravity, settings.duration);
        const float moved = length(motions[i].path) + std::abs(motions[i].turn) * body.reach;
        if (moved > settings.tuning.speculative_distance(body.smallest_extent))
            update_boxes(simulation, bodies.moving[i], motions[i]);
    }
}

// Runs twice in a step: for the caller's changes before it, and after the motion, so that the step reports each sensor
// that a body entered in it.
// New pairs begin, and pairs end, only where a box has moved.
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
            report_removal(simulation, contact);
            simulation.broad.remove_pair(contact.shapes);
        }
        return keep;
    });
    simulation.shapes.forget_destroyed();
    simulation.filters_changed = false;
}

void collide_pairs(Simulation& simulation) {
    simulation.chain_crossings = {.before = simulation.chain_crossings.now};
    simulation.scratch.ordered_impacts.bounces.has_candidates = false;
    for (Contact& contact : simulation.contacts.all())
        if (contact.kind == ContactKind::solid) collide_and_count(simulation, contact);
}

// Touched bodies wake before they are solved, and may touch others that sleep.
void collide_woken(Simulation& simulation) {
    while (wake_touched(simulation)) {
        find_pairs(simulation);
        for (Contact& contact : simulation.contacts.all())
            if (contact.is_new && contact.kind == ContactKind::solid) collide_and_count(simulation, contact);
    }
}

void prepare_constraints(Simulation& simulation) {
    const StepSettings& settings = simulation.settings;
    simulation.scratch.contact_solver.prepare(simulation.contacts.all(), simulation.bodies, settings.tuning,
                                              settings.gravity, settings.substep_duration());
    simulation.joints.prepare(simulation.bodies);
    if (settings.joints == JointSolver::direct)
        simulation.scratch.joint_system.prepare(simulation.joints, simulation.bodies.solver_bodies,
                                                settings.substep_duration(), settings.tuning.push_out_speed);
}

void run_substep(Simulation& simulation) {
    TUMBLE_CHECK(simulation.settings.substeps >= 1);
    const JointContext context = joint_context(simulation);
    const std::span<SolverBody> bodies = simulation.bodies.solver_bodies;
    ContactSolver& contacts = simulation.scratch.contact_solver;
    integrate_velocities(simulation.bodies, simulation.settings.gravity, context.h, speed_limits(simulation));
    JointSystem* system = context.iterates_equalities ? nullptr : &simulation.scratch.joint_system;
    if (system) system->start_substep();
    simulation.joints.warm_start(bodies);
    contacts.warm_start(bodies);
    simulation.joints.solve(context, true, bodies);
    if (system) system->solve_chord(simulation.joints, bodies);
    contacts.solve(bodies, context.inv_h, simulation.settings.tuning.push_out_speed);
    integrate_positions(simulation.bodies, context.h, speed_limits(simulation));
    simulation.joints.solve(context, false, bodies);
    if (system) system->project_velocities(simulation.joints, bodies);
    contacts.relax(bodies, context.inv_h, friction_bound(simulation));
}

void bounce(Simulation& simulation) {
    const StepSettings& settings = simulation.settings;
    simulation.scratch.contact_solver.apply_restitution(
        simulation.bodies.solver_bodies, settings.tuning.restitution_threshold, settings.substep_duration());
}

void store_results(Simulation& simulation) {
    simulation.scratch.contact_solver.store_impulses(simulation.contacts.all(), simulation.bodies.solver_bodies);
    simulation.joints.store(joint_context(simulation));
    simulation.events.broken_joints = simulation.joints.broken();
}

// Joints that contradict each other, or pull a body against an obstacle, accumulate large impulses. These cancel only
// while the bodies do not turn; otherwise they grow without bound (a hundredfold per step) and drive the bodies into
// the speed limits. The joints of clamped bodies therefore start the next step without impulses.
void forget_clamped_impulses(Simulation& simulation) {
    const BodyStore& bodies = simulation.bodies;
    for (std::size_t i = 1; i < bodies.solver_bodies.size(); ++i)
        if (bodies.solver_bodies[i].flags & kClampedBody)
            for (const JointId id : bodies.records[bodies.moving[i].body].joints) simulation.joints.forget_impulses(id);
}

void collide_continuously(Simulation& simulation) {
    if (!simulation.settings.orders_impacts()) return stop_at_impacts(simulation);
    end_flight(simulation);
    simulate_impacts(simulation);
    show_impacts(simulation);
}

void update_proxies(Simulation& simulation) {
    for (std::size_t i = 1; i < simulation.bodies.moving.size(); ++i)
        update_boxes(simulation, simulation.bodies.moving[i], {});
}

}  // namespace tumble
