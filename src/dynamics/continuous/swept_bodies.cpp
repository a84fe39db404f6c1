#include "dynamics/continuous/swept_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "debug/check.hpp"
#include "dynamics/bodies/sweeps.hpp"
#include "dynamics/continuous/contact_lists.hpp"
#include "dynamics/stages/sleep.hpp"

namespace tumble {

namespace {

// How fast a body that contacts or joints push accelerates during the step: the part of its free acceleration that its
// change of velocity shows. The rest of the change has no known time, and counts as made when the step starts.
DVec2 acceleration_of_pushed(DVec2 change, DVec2 free_acceleration, double duration) {
    TUMBLE_CHECK(duration > 0.0);
    const double square = length_sq(free_acceleration);
    if (!(square > 0.0)) return {};
    return std::clamp(dot(change, free_acceleration) / (square * duration), 0.0, 1.0) * free_acceleration;
}

SweptBody make_swept(const Simulation& simulation, std::uint32_t index) {
    const BodyStore& bodies = simulation.bodies;
    const std::uint32_t solver_body = bodies.frames[index].solver_body;
    const SolverBody& body = bodies.solver_bodies[solver_body];
    TUMBLE_CHECK(solver_body != kStaticSolverBody);
    TUMBLE_CHECK(solver_body < bodies.solver_bodies.size());
    SweptBody swept;
    swept.body = index;
    swept.sweep = sweep_of(bodies, index);
    swept.first_angle = swept.sweep.start_angle;
    swept.velocity = {DVec2(body.velocity), body.angular_velocity};
    const bool was_awake = solver_body < simulation.scratch->start_velocities.size();
    if (!was_awake || !(body.flags & kDynamicBody)) return swept;
    const StartVelocity& start = simulation.scratch->start_velocities[solver_body];
    const double duration = static_cast<double>(simulation.settings.duration);
    const Twist change{swept.velocity.linear - start.linear,
                       swept.velocity.angular - static_cast<double>(start.angular)};
    swept.is_free = !(body.flags & kPushedBody);
    if (swept.is_free) {
        swept.acceleration = (1.0 / duration) * change;
    } else {
        const DVec2 free_acceleration(bodies.free_acceleration(solver_body, simulation.settings.gravity));
        swept.acceleration.linear = acceleration_of_pushed(change.linear, free_acceleration, duration);
    }
    swept.velocity = swept.velocity + -duration * swept.acceleration;
    return swept;
}

Aabb box_of(const Simulation& simulation, const SweptBody& swept) {
    Aabb box;
    for (const ShapeId shape : simulation.bodies.records[swept.body].shapes)
        box = merge(box, box_of_sweep(simulation.shapes[shape.index].shape, swept.sweep));
    return box;
}

// Contacts of the island that wakes are solved from the next step on.
void wake_for_impact(Simulation& simulation, std::uint32_t body) {
    if (!simulation.bodies.is_asleep(body)) return;
    wake(simulation, body);
    simulation.scratch->ordered_impacts.swept_of.resize(simulation.bodies.solver_bodies.size(), kNotSwept);
}

}  // namespace

Aabb box_of_sweep(const Shape& shape, const Sweep& sweep) {
    const float reach = farthest_distance(shape, sweep.local_center);
    const Shape disc = make_circle(std::min(reach, std::numeric_limits<float>::max()));
    return merge(bounds(disc, {sweep.start, {}}), bounds(disc, {sweep.end, {}}));
}

bool may_reach_immovable(const Simulation& simulation, std::uint32_t body) {
    constexpr float kRounding = 1e-6f;  // of float boxes, relative to their coordinates
    const BodyFrame& frame = simulation.bodies.frames[body];
    const BodyMotion& motion = simulation.bodies.moving[frame.solver_body].motion;
    const Vec2 start = to_float(frame.center);
    const Vec2 end = start + simulation.bodies.solver_bodies[frame.solver_body].delta_position;
    const Aabb path = merge({start, start}, {end, end});
    const float farthest =
        std::max({std::abs(path.lower.x), std::abs(path.lower.y), std::abs(path.upper.x), std::abs(path.upper.y)});
    const float reach = motion.reach + kRounding * (motion.reach + farthest);
    bool is_near = false;
    simulation.broad.query(
        enlarged(path, reach), [&](std::uint32_t) { is_near = true; }, ProxyLayer::fixed, ProxyLayer::kinematic);
    return is_near;
}

void clear_swept_bodies(Simulation& simulation) {
    ImpactScratch& scratch = simulation.scratch->ordered_impacts;
    scratch.swept.clear();
    scratch.next.clear();
    scratch.leaves.clear();
    scratch.tree.clear();
    scratch.queue.clear();
    clear_contact_lists(simulation);
    scratch.impacts.clear();
    scratch.swept_of.assign(simulation.bodies.solver_bodies.size(), kNotSwept);
}

std::uint32_t find_swept(const Simulation& simulation, std::uint32_t body) {
    TUMBLE_CHECK(body < simulation.bodies.frames.size());
    const std::uint32_t solver_body = simulation.bodies.frames[body].solver_body;
    TUMBLE_CHECK(solver_body < simulation.scratch->ordered_impacts.swept_of.size());
    return solver_body == kStaticSolverBody ? kNotSwept : simulation.scratch->ordered_impacts.swept_of[solver_body];
}

Twist present_velocity(const Simulation& simulation, std::uint32_t body) {
    const std::uint32_t swept = find_swept(simulation, body);
    if (swept != kNotSwept) return simulation.scratch->ordered_impacts.swept[swept].velocity;
    const SolverBody& moved = simulation.bodies.solver_bodies[simulation.bodies.frames[body].solver_body];
    return {DVec2(moved.velocity), moved.angular_velocity};
}

std::uint32_t sweep_body(Simulation& simulation, std::uint32_t body) {
    wake_for_impact(simulation, body);
    ImpactScratch& scratch = simulation.scratch->ordered_impacts;
    const std::uint32_t solver_body = simulation.bodies.frames[body].solver_body;
    TUMBLE_CHECK(solver_body != kStaticSolverBody);
    TUMBLE_CHECK(solver_body < scratch.swept_of.size());
    std::uint32_t& index = scratch.swept_of[solver_body];
    if (index != kNotSwept) return index;
    index = static_cast<std::uint32_t>(scratch.swept.size());
    scratch.swept.push_back(make_swept(simulation, body));
    scratch.next.emplace_back();
    scratch.leaves.push_back(scratch.tree.insert(box_of(simulation, scratch.swept.back()), index));
    return index;
}

ImpactBody make_impact_body(const Simulation& simulation, const SweptBody& swept) {
    const BodyFrame& frame = simulation.bodies.frames[swept.body];
    ImpactBody body;
    body.inv_mass = DVec2(frame.inv_masses());
    body.inv_inertia = frame.inv_inertia;
    body.velocity = swept.velocity;
    body.mean_velocity = swept.mean_velocity(simulation.settings.duration);
    body.acceleration = swept.acceleration.linear;
    body.reach = simulation.bodies.records[swept.body].motion.reach;
    return body;
}

void update_box(Simulation& simulation, std::uint32_t swept) {
    ImpactScratch& scratch = simulation.scratch->ordered_impacts;
    TUMBLE_CHECK(swept < scratch.swept.size());
    TUMBLE_CHECK(scratch.leaves.size() == scratch.swept.size());
    scratch.tree.move(scratch.leaves[swept], box_of(simulation, scratch.swept[swept]));
}

bool has_bounce(Simulation& simulation, std::uint32_t swept) {
    TUMBLE_CHECK(swept < simulation.scratch->ordered_impacts.swept.size());
    const std::uint32_t body = simulation.scratch->ordered_impacts.swept[swept].body;
    const std::span<const BodyContact> contacts = contacts_of(simulation, body);
    return std::any_of(contacts.begin(), contacts.end(), [&](const BodyContact& contact) {
        return simulation.contacts.all()[contact.index].is_bouncing;
    });
}

Sweep motion_until(const Simulation& simulation, std::uint32_t body, double time) {
    const std::uint32_t swept = find_swept(simulation, body);
    if (swept == kNotSwept) return part_of(sweep_of(simulation.bodies, body), 0.0, time);
    const SweptBody& moved = simulation.scratch->ordered_impacts.swept[swept];
    const Sweep ahead = moved.sweep_from(time);
    const DVec2 center = ahead.start + moved.bulge(time, static_cast<double>(simulation.settings.duration));
    return {ahead.local_center, simulation.bodies.frames[body].center, center, moved.first_angle,
            ahead.start_angle - moved.first_angle};
}

void link_impact(Simulation& simulation, int index) {
    ImpactScratch& scratch = simulation.scratch->ordered_impacts;
    Impact& impact = scratch.impacts[static_cast<std::size_t>(index)];
    const auto exchange_last = [&](std::uint32_t shape) {
        const std::uint32_t swept = find_swept(simulation, simulation.shapes[shape].body);
        return swept == kNotSwept ? -1 : std::exchange(scratch.swept[swept].last_impact, index);
    };
    impact.previous_of_a = exchange_last(impact.shapes.a);
    impact.previous_of_b = exchange_last(impact.shapes.b);
}

void store_swept_bodies(Simulation& simulation) {
    for (const SweptBody& swept : simulation.scratch->ordered_impacts.swept) {
        if (swept.impact_count == 0) continue;
        const BodyFrame& frame = simulation.bodies.frames[swept.body];
        TUMBLE_CHECK(frame.solver_body != kStaticSolverBody);
        SolverBody& body = simulation.bodies.solver_bodies[frame.solver_body];
        if (!(body.flags & kDynamicBody)) continue;
        const Twist velocity = swept.final_velocity(simulation.settings.duration);
        body.velocity = to_float(velocity.linear);
        body.angular_velocity = static_cast<float>(velocity.angular);
        body.delta_position = to_float(swept.sweep.end - frame.center);
        body.delta_rotation = make_rotation(swept.sweep.start_angle + swept.sweep.turn - angle(frame.pose.rotation));
    }
}

}  // namespace tumble
