#include "dynamics/step.hpp"

#include <chrono>
#include <cmath>
#include <optional>

#include "debug/check.hpp"
#include "dynamics/bodies/divergence.hpp"
#include "dynamics/bodies/final_poses.hpp"
#include "dynamics/bodies/integrate.hpp"
#include "dynamics/collision.hpp"
#include "dynamics/contacts/contact_block.hpp"
#include "dynamics/continuous/bounces.hpp"
#include "dynamics/continuous/continuous.hpp"
#include "dynamics/continuous/free_flight.hpp"
#include "dynamics/continuous/immovable_bounds.hpp"
#include "dynamics/continuous/ordered_impacts.hpp"
#include "dynamics/continuous/sensor_crossings.hpp"
#include "dynamics/stages/body_order.hpp"
#include "dynamics/stages/events.hpp"
#include "dynamics/stages/seams.hpp"
#include "dynamics/stages/sleep.hpp"

namespace tumble {

namespace {

// Below this amount of work, reading the clock for every stage would be a tenth of the step.
constexpr std::size_t kLeastTimed = 16;

// Measures stages with one reading of the clock between two of them, or the step alone.
class StageClock {
public:
    explicit StageClock(bool by_stage) : by_stage_(by_stage) {}

    // Adds the time since the last call, or since the start, to a stage, ms.
    void stop(double& stage_ms) {
        if (!by_stage_) return;
        const Clock::time_point now = Clock::now();
        stage_ms += milliseconds(now - last_);
        last_ = now;
    }
    double total() const { return milliseconds((by_stage_ ? last_ : Clock::now()) - start_); }

private:
    using Clock = std::chrono::steady_clock;
    static double milliseconds(Clock::duration time) { return std::chrono::duration<double, std::milli>(time).count(); }

    bool by_stage_;
    Clock::time_point start_ = Clock::now();
    Clock::time_point last_ = start_;
};

SpeedLimits speed_limits(const Simulation& simulation) { return simulation.settings.speed_limits(); }

FrictionBound friction_bound(const Simulation& simulation) {
    return simulation.settings.orders_impacts() ? FrictionBound::rigid : FrictionBound::biased;
}

JointContext joint_context(const Simulation& simulation) {
    const float h = simulation.settings.substep_duration();
    return {h, 1.0f / h, joint_softness(simulation.settings.tuning, h)};
}

// Joints may connect any bodies, so that a world in which one is awake is one region.
std::uint32_t least_region(const Simulation& simulation) {
    return simulation.joints.awake_count() > 0 ? kOneRegion : kLeastRegion;
}

constexpr std::size_t kLeastBoxes = 128;  // in a chunk: about 3 us of work

// A measure of the work of a step: see Threads::least_work.
std::size_t amount_of_work(const Simulation& simulation) {
    return simulation.bodies.moving.size() + simulation.contacts.all().size() + simulation.joints.awake_count();
}

// For a pass over the solver bodies: loads what find_moved_proxies() reads of a body that follows soon. On two threads,
// with final_poses.cpp, it saves 2 to 5 % of a step where several thousand bodies move.
void prefetch_moved_after(const Simulation& simulation, std::size_t solver_body) {
    constexpr std::size_t kAhead = 4;
    const std::vector<MovingBody>& moving = simulation.bodies.moving;
    simulation.bodies.prefetch_frame_after(solver_body);
    if (solver_body + kAhead >= moving.size()) return;
    const std::uint32_t shape = moving[solver_body + kAhead].motion.only_shape;
    if (shape == kNoShape) return;
    simulation.shapes.prefetch(shape);
    simulation.broad.prefetch(shape);
}

// Lists the shapes of a body that have left their boxes, with the new ones.
void find_moved_proxies(const Simulation& simulation, const MovingBody& moving, const FreeMotion& ahead,
                        std::vector<BroadPhase::MovedProxy>& moved) {
    const Pose& pose = simulation.bodies.frames[moving.body].pose;
    const auto find = [&](std::uint32_t shape) {
        const std::optional<Aabb> box =
            simulation.shapes.new_box(shape, pose, ahead, simulation.settings.tuning, simulation.broad);
        if (box) moved.push_back({shape, *box});
    };
    if (moving.motion.only_shape != kNoShape) return find(moving.motion.only_shape);
    for (const ShapeId shape : simulation.bodies.records[moving.body].shapes) find(shape.index);
}

// The parts of a step that the crew works on together, with serial ones between them that may take long.
void begin_step(Simulation& simulation, StageClock& clock) {
    StageTimes& ms = simulation.report.times;
    if (simulation.settings.orders_impacts()) {
        simulation.touch_kept();
        end_contacts(simulation, EndOf::all_contacts);  // before their boxes may overlap again
        cover_free_motions(simulation);
    }
    find_pairs(simulation, EndOf::all_contacts);
    clock.stop(ms.pairs);
    simulation.report.collided = {};
    collide_pairs(simulation);
    collide_woken(simulation);
    smooth_seams(simulation);
    if (simulation.settings.orders_impacts()) find_bounces(simulation);
    clock.stop(ms.collide);
}

void run_substep(Simulation& simulation, const ContactSolver::Region& region, Crew& crew) {
    const JointContext context = joint_context(simulation);
    const std::span<SolverBody> bodies = simulation.bodies.solver_bodies;
    ContactSolver& contacts = simulation.scratch->contact_solver;
    integrate_velocities(simulation.bodies, region.bodies, simulation.settings.gravity, context.h,
                         speed_limits(simulation), crew);
    JointSystem* system = simulation.joints.has_direct() ? &simulation.scratch->joint_system : nullptr;
    if (system) system->warm_start(bodies);
    simulation.joints.warm_start(bodies, crew);
    contacts.warm_start(region, bodies, crew);
    simulation.joints.solve(context, true, bodies, crew);
    contacts.solve(region, bodies, context.inv_h, simulation.settings.tuning.push_out_speed, crew);
    if (system) system->solve_chord(simulation.joints, bodies);
    integrate_positions(simulation.bodies, region.bodies, context.h, speed_limits(simulation), crew);
    simulation.joints.solve(context, false, bodies, crew);
    contacts.relax(region, bodies, context.inv_h, friction_bound(simulation), crew);
    if (system) system->project_velocities(simulation.joints, bodies);
}

void solve(Simulation& simulation, StageClock& clock) {
    StageTimes& ms = simulation.report.times;
    prepare_constraints(simulation);
    simulation.report.colors = simulation.scratch->contact_solver.graph().color_count();
    clock.stop(ms.prepare);
    if (simulation.settings.orders_impacts()) begin_flight(simulation);
    run_substeps(simulation);
    if (!simulation.settings.orders_impacts()) bounce(simulation);
    store_results(simulation);
    forget_clamped_impulses(simulation);
    clock.stop(ms.solve);
}

// False if a body is not finite.
bool end_motion(Simulation& simulation, StageClock& clock) {
    StageTimes& ms = simulation.report.times;
    const bool may_go_on = finalize_poses(simulation.bodies, speed_limits(simulation), simulation.crew);
    clock.stop(ms.continuous);
    if (!may_go_on && find_diverged(simulation.bodies) != kNoBody) return false;
    update_proxies(simulation);
    clock.stop(ms.proxies);
    simulation.touch_kept();
    find_pairs(simulation, EndOf::untouched_contacts);
    clock.stop(ms.pairs);
    report_events(simulation);
    clock.stop(ms.events);
    return true;
}

}  // namespace

bool step(Simulation& simulation, std::uint64_t earlier_steps) {
    simulation.report.times = StageTimes{};
    const std::size_t amount = amount_of_work(simulation);
    StageClock clock(amount >= kLeastTimed);
    clear(simulation.events);
    Crew& crew = simulation.crew;
    bool is_finite = false;
    if (earlier_steps % kStepsBetweenOrders == 0) order_bodies(simulation);
    crew.work_together(amount, [&] { begin_step(simulation, clock); });
    crew.work_together(amount, [&] { solve(simulation, clock); });
    collide_continuously(simulation);
    find_sensor_crossings(simulation);
    crew.work_together(amount, [&] { is_finite = end_motion(simulation, clock); });
    if (is_finite) {
        fall_asleep(simulation);
        clock.stop(simulation.report.times.sleep);
    }
    simulation.report.times.step = clock.total();
    return is_finite;
}

// The boxes of a body that moves less than its speculative distance have margin enough.
void cover_free_motions(Simulation& simulation) {
    const StepSettings& settings = simulation.settings;
    const BodyStore& bodies = simulation.bodies;
    std::vector<FreeMotion>& motions = simulation.scratch->free_motions;
    motions.resize(bodies.moving.size());
    ChunkLists<BroadPhase::MovedProxy>& moved_proxies = simulation.scratch->chunks.moved_proxies;
    moved_proxies.fill(simulation.crew, motions.size(), kLeastBoxes, [&](std::size_t i, auto& list) {
        if (i == kStaticSolverBody) return;
        const BodyMotion& body = bodies.moving[i].motion;
        motions[i] = bodies.free_motion(static_cast<std::uint32_t>(i), settings.gravity, settings.duration);
        const float moved = length(motions[i].path) + std::abs(motions[i].turn) * body.reach;
        if (moved > settings.tuning.speculative_distance(body.smallest_extent))
            find_moved_proxies(simulation, bodies.moving[i], motions[i], list);
    });
    simulation.broad.move(moved_proxies, simulation.crew);
}

void prepare_constraints(Simulation& simulation) {
    const StepSettings& settings = simulation.settings;
    TUMBLE_CHECK(simulation.contacts.woken().empty());
    const BounceBy bounces = settings.orders_impacts() ? BounceBy::impacts : BounceBy::solver;
    simulation.scratch->contact_solver.prepare(simulation.contacts.all(), simulation.bodies, settings.tuning,
                                               settings.gravity, settings.substep_duration(), bounces,
                                               least_region(simulation), simulation.crew);
    simulation.joints.prepare(simulation.bodies, settings.joints, settings.substep_duration(), simulation.crew);
    simulation.joints.choose_direct(simulation.bodies, [&](std::uint32_t solver_body) {
        return simulation.scratch->contact_solver.graph().has_contact(solver_body);
    });
    if (simulation.joints.has_direct())
        simulation.scratch->joint_system.prepare(simulation.joints, simulation.bodies.solver_bodies,
                                                 settings.substep_duration(), settings.tuning.push_out_speed);
}

void run_substeps(Simulation& simulation) {
    TUMBLE_CHECK(simulation.settings.substeps >= 1);
    const auto run = [&](const ContactSolver::Region& region, Crew& crew) {
        for (int i = 0; i < simulation.settings.substeps; ++i) run_substep(simulation, region, crew);
    };
    simulation.scratch->contact_solver.for_each_region(simulation.crew, run);
}

void bounce(Simulation& simulation) {
    const StepSettings& settings = simulation.settings;
    simulation.scratch->contact_solver.apply_restitution(simulation.bodies.solver_bodies,
                                                         settings.tuning.restitution_threshold,
                                                         settings.substep_duration(), simulation.crew);
}

void store_results(Simulation& simulation) {
    simulation.scratch->contact_solver.store_impulses(simulation.contacts.all(), simulation.bodies.solver_bodies,
                                                      simulation.crew);
    simulation.joints.store(joint_context(simulation), simulation.crew);
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
    keep_out_of_immovable(simulation);
    show_impacts(simulation);
}

void update_proxies(Simulation& simulation) {
    const std::vector<MovingBody>& moving = simulation.bodies.moving;
    ChunkLists<BroadPhase::MovedProxy>& moved_proxies = simulation.scratch->chunks.moved_proxies;
    moved_proxies.fill(simulation.crew, moving.size(), kLeastBoxes, [&](std::size_t i, auto& list) {
        prefetch_moved_after(simulation, i);
        if (i != kStaticSolverBody) find_moved_proxies(simulation, moving[i], {}, list);
    });
    simulation.broad.move(moved_proxies, simulation.crew);
}

}  // namespace tumble
