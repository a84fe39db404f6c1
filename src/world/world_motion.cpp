// The motion of bodies between steps: poses, velocities, energy, forces, impulses and sleep.
#include <stdexcept>
#include <string>

#include "dynamics/rows/joint_angle.hpp"
#include "dynamics/stages/sleep.hpp"
#include "world/input_checks.hpp"
#include "world/world_impl.hpp"

namespace tumble {

namespace {

// Wakes a dynamic body and returns its entry among the moving bodies; nullptr for a body of another type.
MovingBody* wake_dynamic(Simulation& simulation, BodyId id) {
    if (!simulation.bodies.is_dynamic(id.index)) return nullptr;
    wake(simulation, id.index);
    return &simulation.bodies.moving[simulation.bodies.frames[id.index].solver_body];
}

Energy energy_of(const Simulation& simulation, BodyId id) {
    const BodyStore& bodies = simulation.bodies;
    if (!bodies.is_dynamic(id.index)) return {};
    const BodyRecord& record = bodies.records[id.index];
    const BodyFrame& frame = bodies.frames[id.index];
    const SolverBody& body = bodies.solver_bodies[frame.solver_body];
    const DVec2 velocity(body.velocity), gravity(simulation.settings.gravity);
    const double mass = double{record.mass.mass}, turn = double{body.angular_velocity};
    const double weight = mass * double{record.motion.gravity_scale};
    return {0.5 * mass * dot(velocity, velocity) + 0.5 * double{record.mass.inertia} * turn * turn,
            -weight * dot(gravity, transform_point(frame.pose, record.mass.center))};
}

}  // namespace

Energy World::energy(BodyId id) const {
    impl_->require(id);
    return energy_of(impl_->simulation, id);
}

Energy World::energy() const {
    Energy sum;
    for (const BodyId id : impl_->simulation.bodies.ids.live()) {
        const Energy own = energy_of(impl_->simulation, id);
        sum.kinetic += own.kinetic;
        sum.potential += own.potential;
    }
    return sum;
}

DVec2 World::momentum() const {
    const BodyStore& store = impl_->simulation.bodies;
    DVec2 sum;
    for (const BodyId id : store.ids.live()) {
        if (!store.is_dynamic(id.index)) continue;
        const SolverBody& body = store.solver_bodies[store.frames[id.index].solver_body];
        sum = sum + double{store.records[id.index].mass.mass} * DVec2(body.velocity);
    }
    return sum;
}

void World::read_states(const BodyStateArrays& out) const {
    const BodyStore& bodies = impl_->simulation.bodies;
    const std::span<const BodyId> ids = bodies.ids.live();
    // Calls write(entry, index) for each body, if there is an array for it.
    const auto fill = [&](auto array, const char* name, auto&& write) {
        if (array.empty()) return;
        if (array.size() != ids.size())
            throw std::invalid_argument(std::string(name) + " needs one entry for each body: it has " +
                                        std::to_string(array.size()) + ", the world has " + std::to_string(ids.size()) +
                                        " bodies");
        for (std::size_t i = 0; i < ids.size(); ++i) {
            const BodyFrame& frame = bodies.frames[ids[i].index];
            array[i] = write(frame, bodies.solver_bodies[frame.solver_body]);
        }
    };
    fill(out.positions, "positions", [](const BodyFrame& frame, const SolverBody&) { return frame.pose.position; });
    fill(out.angles, "angles", [](const BodyFrame& frame, const SolverBody&) { return angle(frame.pose.rotation); });
    fill(out.velocities, "velocities", [](const BodyFrame&, const SolverBody& body) { return body.velocity; });
    fill(out.angular_velocities, "angular_velocities",
         [](const BodyFrame&, const SolverBody& body) { return body.angular_velocity; });
}

Vec2 World::velocity_at(BodyId id, DVec2 point) const {
    impl_->require(id);
    check_point(point);
    const BodyFrame& frame = impl_->simulation.bodies.frames[id.index];
    const SolverBody& body = impl_->simulation.bodies.solver_bodies[frame.solver_body];
    return body.velocity + cross(body.angular_velocity, to_float(point - frame.center));
}

void World::set_transform(BodyId id, const Pose& pose) {
    impl_->require(id);
    check_pose(pose, "body");
    Simulation& simulation = impl_->simulation;
    wake_with_neighbors(simulation, id.index);
    impl_->remove_proxies(id);
    simulation.bodies.set_pose(id.index, pose);
    impl_->add_proxies(id);
    wake_overlapping(simulation, id.index);
}

void World::set_velocity(BodyId id, Vec2 velocity, float angular_velocity) {
    impl_->require(id);
    check_velocity(velocity, angular_velocity);
    BodyStore& bodies = impl_->simulation.bodies;
    if (bodies.frames[id.index].type == BodyType::static_body)
        throw std::invalid_argument("body " + std::to_string(id.index) +
                                    " is static or disabled: it has no velocity to set");
    if (bodies.is_dynamic(id.index)) wake(impl_->simulation, id.index);
    const bool was_active = bodies.is_active(id.index);
    SolverBody& body = bodies.solver_bodies[bodies.frames[id.index].solver_body];
    body.velocity = allowed(body.flags, velocity);
    body.angular_velocity = allowed(body.flags, angular_velocity);
    if (was_active || !bodies.is_active(id.index)) return;
    // A kinematic body starts to move: it carries the bodies that rest on it, and may run into sleeping ones.
    wake_with_neighbors(impl_->simulation, id.index);
    impl_->touch_proxies(id);
}

void World::move_towards(BodyId id, const Pose& pose) {
    impl_->require(id);
    check_pose(pose, "body");
    const BodyFrame& frame = impl_->simulation.bodies.frames[id.index];
    const DVec2 displacement =
        transform_point(pose, impl_->simulation.bodies.records[id.index].mass.center) - frame.center;
    const double turn = relative_angle(frame.pose.rotation, pose.rotation);
    const double rate = double{impl_->def.steps_per_second};
    set_velocity(id, to_float(rate * displacement), static_cast<float>(rate * turn));
}

void World::apply_force(BodyId id, Vec2 force) {
    impl_->require(id);
    apply_force(id, force, impl_->simulation.bodies.frames[id.index].center);
}

void World::apply_impulse(BodyId id, Vec2 impulse) {
    impl_->require(id);
    apply_impulse(id, impulse, impl_->simulation.bodies.frames[id.index].center);
}

void World::apply_force(BodyId id, Vec2 force, DVec2 point) {
    impl_->require(id);
    check_action(force, "force");
    check_point(point);
    MovingBody* const moving = wake_dynamic(impl_->simulation, id);
    if (!moving) return;
    const BodyFrame& frame = impl_->simulation.bodies.frames[id.index];
    moving->acceleration += scaled(frame.inv_masses(), force);
    moving->angular_acceleration += frame.inv_inertia * cross(to_float(point - frame.center), force);
}

void World::apply_torque(BodyId id, float torque) {
    impl_->require(id);
    check_action(torque, "torque");
    MovingBody* const moving = wake_dynamic(impl_->simulation, id);
    if (moving) moving->angular_acceleration += impl_->simulation.bodies.frames[id.index].inv_inertia * torque;
}

void World::apply_impulse(BodyId id, Vec2 impulse, DVec2 point) {
    impl_->require(id);
    check_action(impulse, "impulse");
    check_point(point);
    if (!wake_dynamic(impl_->simulation, id)) return;
    const BodyFrame& frame = impl_->simulation.bodies.frames[id.index];
    SolverBody& body = impl_->simulation.bodies.solver_bodies[frame.solver_body];
    body.velocity += scaled(frame.inv_masses(), impulse);
    body.angular_velocity += frame.inv_inertia * cross(to_float(point - frame.center), impulse);
}

void World::apply_angular_impulse(BodyId id, float impulse) {
    impl_->require(id);
    check_action(impulse, "angular impulse");
    if (!wake_dynamic(impl_->simulation, id)) return;
    const BodyFrame& frame = impl_->simulation.bodies.frames[id.index];
    impl_->simulation.bodies.solver_bodies[frame.solver_body].angular_velocity += frame.inv_inertia * impulse;
}

bool World::is_awake(BodyId id) const {
    impl_->require(id);
    return !impl_->simulation.bodies.is_asleep(id.index);
}

void World::set_awake(BodyId id, bool awake) {
    impl_->require(id);
    Simulation& simulation = impl_->simulation;
    if (awake)
        wake(simulation, id.index);
    else if (simulation.bodies.is_dynamic(id.index) && !simulation.bodies.is_asleep(id.index))
        put_island_to_sleep(simulation, id.index);
}

}  // namespace tumble
