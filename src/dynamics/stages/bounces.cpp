#include "dynamics/stages/bounces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dynamics/contacts/collide_contact.hpp"

namespace tumble {

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

bool has_joints(const Simulation& simulation, const Contact& contact) {
    const std::vector<BodyRecord>& records = simulation.bodies.records;
    return !records[contact.body_a].joints.empty() || !records[contact.body_b].joints.empty();
}

void count_touches(Simulation& simulation) {
    std::vector<std::uint32_t>& counts = simulation.scratch.ordered_impacts.touch_counts;
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
    return simulation.scratch.ordered_impacts.touch_counts[a_is_faster ? a : b] > 1;
}

// A contact approached faster than this is an impact, m/s. Joints do not take part in impacts: the solver does better
// for a joined body that does not bounce.
double impact_threshold(const Simulation& simulation, const Contact& contact) {
    if (contact.restitution > 0.0f) return bounce_threshold(simulation, contact);
    if (has_joints(simulation, contact) || !carries_others(simulation, contact)) return kNever;
    return static_cast<double>(simulation.settings.tuning.hit_speed);
}

float free_acceleration(const Simulation& simulation, std::uint32_t body) {
    const BodyStore& bodies = simulation.bodies;
    return length(bodies.free_acceleration(bodies.frames[body].solver_body, simulation.settings.gravity));
}

}  // namespace

// The larger of the two accelerations, not their difference along the normal: that is 0 for two bodies of a pile.
double bounce_threshold(const Simulation& simulation, const Contact& contact) {
    const float acceleration =
        std::max(free_acceleration(simulation, contact.body_a), free_acceleration(simulation, contact.body_b));
    const float restitution = contact.restitution > 0.0f ? contact.restitution : 1.0f;
    return static_cast<double>(2.0f * simulation.settings.duration * acceleration / restitution);
}

void find_bounces(Simulation& simulation) {
    count_touches(simulation);
    for (Contact& contact : simulation.contacts.all()) {
        if (contact.manifold.point_count == 0) {
            contact.is_bouncing = false;
            continue;
        }
        const double threshold = impact_threshold(simulation, contact);
        contact.is_bouncing = contact.is_struck = false;
        for (int i = 0; i < contact.manifold.point_count; ++i) {
            const ManifoldPoint& point = contact.manifold.points[i];
            const bool is_fast = static_cast<double>(approach_speed(contact, point, simulation.bodies)) > threshold;
            contact.is_bouncing |= is_fast;
            contact.is_struck |= is_fast && point.separation <= 0.0f;
        }
    }
}

}  // namespace tumble
