#include "dynamics/stages/bounces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dynamics/contacts/collide_contact.hpp"

namespace tumble {

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

// Joints do not take part in impacts: without a bounce the solver does better.
bool has_joints(const Simulation& simulation, const Contact& contact) {
    const std::vector<BodyRecord>& records = simulation.bodies.records;
    return !records[contact.body_a].joints.empty() || !records[contact.body_b].joints.empty();
}

// A contact approached faster than this is an impact, m/s.
double impact_threshold(const Simulation& simulation, const Contact& contact) {
    const StepSettings& settings = simulation.settings;
    const float extent = contact.speculative_distance / kSpeculativePart;
    const double fast = static_cast<double>(settings.tuning.swept_distance(extent) / settings.duration);
    if (contact.restitution == 0.0f) return has_joints(simulation, contact) ? kNever : fast;
    return std::min(fast, bounce_threshold(simulation, contact.body_a, contact.body_b, contact.manifold.normal));
}

}  // namespace

double bounce_threshold(const Simulation& simulation, std::uint32_t body_a, std::uint32_t body_b, Vec2 normal) {
    const BodyStore& bodies = simulation.bodies;
    const Vec2 gravity = simulation.settings.gravity;
    const Vec2 acceleration = bodies.free_acceleration(bodies.frames[body_b].solver_body, gravity) -
                              bodies.free_acceleration(bodies.frames[body_a].solver_body, gravity);
    return static_cast<double>(2.0f * simulation.settings.duration * std::abs(dot(acceleration, normal)));
}

void find_bounces(Simulation& simulation) {
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
