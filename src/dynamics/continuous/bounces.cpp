#include "dynamics/continuous/bounces.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "dynamics/contacts/collide_contact.hpp"

namespace tumble {

namespace {

// In each group of touching bodies, the kMaxLandings fastest landings of bodies that carry others are impacts, and one
// more for each kBodiesPerLanding bodies of the group. The solver gets the rest. Larger: impacts cost more than the
// rest of the step.
constexpr std::uint32_t kMaxLandings = 8;
constexpr std::uint32_t kBodiesPerLanding = 16;

bool has_joints(const Simulation& simulation, const Contact& contact) {
    const std::vector<BodyRecord>& records = simulation.bodies.records;
    return !records[contact.body_a].joints.empty() || !records[contact.body_b].joints.empty();
}

void count_touches(Simulation& simulation) {
    std::vector<std::uint32_t>& counts = simulation.scratch->ordered_impacts.bounces.touch_counts;
    counts.assign(simulation.bodies.solver_bodies.size(), 0);
    for (const Contact& contact : simulation.contacts.all()) {
        if (contact.manifold.point_count == 0) continue;
        ++counts[simulation.bodies.frames[contact.body_a].solver_body];
        ++counts[simulation.bodies.frames[contact.body_b].solver_body];
    }
}

// True if the faster body of the two touches others too.
bool carries_others(const Simulation& simulation, const Contact& contact) {
    const BodyStore& bodies = simulation.bodies;
    const std::uint32_t a = bodies.frames[contact.body_a].solver_body, b = bodies.frames[contact.body_b].solver_body;
    const bool a_is_faster = length_sq(bodies.solver_bodies[a].velocity) > length_sq(bodies.solver_bodies[b].velocity);
    return simulation.scratch->ordered_impacts.bounces.touch_counts[a_is_faster ? a : b] > 1;
}

float free_acceleration(const Simulation& simulation, std::uint32_t body) {
    const BodyStore& bodies = simulation.bodies;
    return length(bodies.free_acceleration(bodies.frames[body].solver_body, simulation.settings.gravity));
}

// The solver leaves the contact to continuous collision if it is approached faster than the threshold. Returns the
// largest approach, m/s.
double mark_bounce(Contact& contact, const BodyStore& bodies, double threshold) {
    double largest = 0.0;
    for (int i = 0; i < contact.manifold.point_count; ++i) {
        const ManifoldPoint& point = contact.manifold.points[i];
        const double speed = static_cast<double>(approach_speed(contact, point, bodies));
        largest = std::max(largest, speed);
        contact.is_bouncing |= speed > threshold;
        contact.is_struck |= speed > threshold && point.separation <= 0.0f;
    }
    return largest;
}

// True if the shapes approach each other by more than the smaller one's extent in a sub-step. The solver applies an
// impulse when a sub-step starts, and friction would act long before the shapes touch.
bool outruns_substeps(const Simulation& simulation, const Contact& contact, double speed) {
    const float extent = smaller_extent(simulation.shapes[contact.shapes.a], simulation.shapes[contact.shapes.b]);
    return speed * static_cast<double>(simulation.settings.substep_duration()) > static_cast<double>(extent);
}

void mark_inelastic(Simulation& simulation, std::uint32_t index, double threshold) {
    Contact& contact = simulation.contacts.all()[index];
    const double speed = mark_bounce(contact, simulation.bodies, threshold);
    if (!contact.is_bouncing || outruns_substeps(simulation, contact, speed)) return;
    if (carries_others(simulation, contact))
        simulation.scratch->ordered_impacts.bounces.landings.push_back({speed, index});
    else
        contact.is_bouncing = contact.is_struck = false;
}

// Finds the groups of awake dynamic bodies that touch each other, and their sizes.
void find_groups(Simulation& simulation) {
    const BodyStore& bodies = simulation.bodies;
    IslandFinder& groups = simulation.scratch->islands;
    groups.reset(bodies.solver_bodies.size());
    for (const Contact& contact : simulation.contacts.all()) {
        if (contact.manifold.point_count == 0) continue;
        const std::uint32_t a = bodies.frames[contact.body_a].solver_body;
        const std::uint32_t b = bodies.frames[contact.body_b].solver_body;
        if (bodies.solver_bodies[a].flags & bodies.solver_bodies[b].flags & kDynamicBody) groups.join(a, b);
    }
    BounceScratch& scratch = simulation.scratch->ordered_impacts.bounces;
    scratch.group_sizes.assign(bodies.solver_bodies.size(), 0);
    scratch.group_landings.assign(bodies.solver_bodies.size(), 0);
    for (std::uint32_t i = 1; i < bodies.solver_bodies.size(); ++i) ++scratch.group_sizes[groups.root(i)];
}

// The root of the group of the contact's first dynamic body.
std::uint32_t group_of(Simulation& simulation, const Contact& contact) {
    const std::uint32_t body = simulation.bodies.is_dynamic(contact.body_a) ? contact.body_a : contact.body_b;
    return simulation.scratch->islands.root(simulation.bodies.frames[body].solver_body);
}

// Leaves all but the fastest landings of each group to the solver.
void keep_slow_landings(Simulation& simulation) {
    BounceScratch& scratch = simulation.scratch->ordered_impacts.bounces;
    if (scratch.landings.size() <= kMaxLandings) return;
    find_groups(simulation);
    std::sort(scratch.landings.begin(), scratch.landings.end(), std::greater<>{});
    for (const Landing& landing : scratch.landings) {
        Contact& contact = simulation.contacts.all()[landing.contact];
        const std::uint32_t group = group_of(simulation, contact);
        const std::uint32_t most = kMaxLandings + scratch.group_sizes[group] / kBodiesPerLanding;
        if (++scratch.group_landings[group] > most) contact.is_bouncing = contact.is_struck = false;
    }
}

}  // namespace

// The larger of the two accelerations, not their difference along the normal: that is 0 for two bodies of a pile.
double bounce_threshold(const Simulation& simulation, const Contact& contact) {
    const float acceleration =
        std::max(free_acceleration(simulation, contact.body_a), free_acceleration(simulation, contact.body_b));
    const float restitution = contact.restitution > 0.0f ? contact.restitution : 1.0f;
    return static_cast<double>(2.0f * simulation.settings.duration * acceleration / restitution);
}

bool note_bounce(const Simulation& simulation, Contact& contact) {
    const float least = contact.restitution > 0.0f ? 0.0f : simulation.settings.tuning.hit_speed;
    contact.is_bouncing = contact.is_struck = false;
    for (int i = 0; i < contact.manifold.point_count; ++i)
        contact.is_bouncing |= approach_speed(contact, contact.manifold.points[i], simulation.bodies) > least;
    // The solver, which would replace those of the last step, may leave it out.
    if (contact.is_bouncing) contact.applied[0] = contact.applied[1] = {};
    return contact.is_bouncing;
}

void find_bounces(Simulation& simulation) {
    BounceScratch& scratch = simulation.scratch->ordered_impacts.bounces;
    if (!scratch.has_candidates) return;
    count_touches(simulation);
    scratch.landings.clear();
    const double hit_speed = static_cast<double>(simulation.settings.tuning.hit_speed);
    for (std::uint32_t i = 0; i < simulation.contacts.all().size(); ++i) {
        Contact& contact = simulation.contacts.all()[i];
        if (!contact.is_bouncing) continue;
        contact.is_bouncing = false;
        // Joints do not take part in impacts: the solver does better for a joined body that does not bounce.
        if (contact.restitution > 0.0f)
            mark_bounce(contact, simulation.bodies, bounce_threshold(simulation, contact));
        else if (!has_joints(simulation, contact))
            mark_inelastic(simulation, i, hit_speed);
    }
    keep_slow_landings(simulation);
}

}  // namespace tumble
