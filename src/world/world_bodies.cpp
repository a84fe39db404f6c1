// Bodies between steps: what they are made to do, and what they are made into.
#include <string>

#include "dynamics/rows/joint_angle.hpp"
#include "dynamics/stages/sleep.hpp"
#include "tumble/world.hpp"
#include "world/input_checks.hpp"
#include "world/require.hpp"
#include "world/world_impl.hpp"

namespace tumble {

MovingBody* World::Impl::wake_to_push(BodyId id) {
    if (!simulation.bodies.is_dynamic(id.index)) return nullptr;
    wake(simulation, id.index);
    return &simulation.bodies.moving[simulation.bodies.frames[id.index].solver_body];
}

template <class Change>
void World::Impl::change_motion(BodyId id, Change&& change) {
    require(id);
    wake(simulation, id.index);
    BodyMotion motion = simulation.bodies.records[id.index].motion;
    change(motion);
    simulation.bodies.set_motion(id.index, motion);
}

BodyType World::type(BodyId id) const {
    impl_->require(id);
    return impl_->simulation.bodies.records[id.index].type;
}

BodyState World::state(BodyId id) const {
    impl_->require(id);
    const BodyFrame& frame = impl_->simulation.bodies.frames[id.index];
    const SolverBody& body = impl_->simulation.bodies.solver_bodies[frame.solver_body];
    return {frame.pose, body.velocity, body.angular_velocity};
}

BodyMass World::mass(BodyId id) const {
    impl_->require(id);
    return impl_->simulation.bodies.records[id.index].mass;
}

BodyDef World::definition(BodyId id) const {
    impl_->require(id);
    const BodyStore& bodies = impl_->simulation.bodies;
    const BodyRecord& record = bodies.records[id.index];
    const BodyState now = state(id);
    const auto has = [&](BodyFlag flag) { return (record.flags & flag) != 0; };
    BodyDef def;
    def.type = record.type;
    def.pose = now.pose;
    def.velocity = now.velocity;
    def.angular_velocity = now.angular_velocity;
    def.linear_damping = record.motion.linear_damping;
    def.angular_damping = record.motion.angular_damping;
    def.gravity_scale = record.motion.gravity_scale;
    def.allow_fast_rotation = has(kFastSpin);
    def.bullet = has(kBulletBody);
    def.allow_sleep = record.motion.allow_sleep;
    def.awake = !bodies.is_asleep(id.index);
    def.locks = {has(kLockX), has(kLockY), has(kLockRotation)};
    def.enabled = record.is_enabled;
    def.mass = record.own_mass;
    return def;
}

void World::set_transform(BodyId id, const Pose& pose) {
    impl_->require(id);
    check_pose(pose, "body");
    Simulation& simulation = impl_->simulation;
    wake_with_neighbors(simulation, id.index);
    impl_->displace_shapes(id);
    simulation.bodies.set_pose(id.index, pose);
    impl_->place_shapes(id);
    wake_overlapping(simulation, id.index);
}

void World::set_type(BodyId id, BodyType type) {
    impl_->require(id);
    Simulation& simulation = impl_->simulation;
    if (type == simulation.bodies.records[id.index].type) return;
    wake_with_neighbors(simulation, id.index);
    impl_->displace_shapes(id);
    simulation.bodies.set_type(id.index, type);
    impl_->place_shapes(id);
    impl_->update_mass(id);
    simulation.filters_changed = true;  // two static bodies have no contact
}

void World::set_enabled(BodyId id, bool enabled) {
    impl_->require(id);
    Simulation& simulation = impl_->simulation;
    BodyRecord& record = simulation.bodies.records[id.index];
    if (enabled == record.is_enabled) return;
    wake_with_neighbors(simulation, id.index);
    impl_->displace_shapes(id);
    simulation.bodies.set_enabled(id.index, enabled);
    impl_->place_shapes(id);
    impl_->update_mass(id);
    if (!enabled) simulation.joints.put_to_sleep(record.joints);
    for (const JointId joint : record.joints) impl_->wake_tied(joint);
    wake_overlapping(simulation, id.index);
    simulation.filters_changed = true;
}

bool World::is_enabled(BodyId id) const {
    impl_->require(id);
    return impl_->simulation.bodies.records[id.index].is_enabled;
}

void World::set_locks(BodyId id, BodyLocks locks) {
    impl_->require(id);
    BodyStore& bodies = impl_->simulation.bodies;
    wake(impl_->simulation, id.index);
    bodies.set_flag(id.index, kLockX, locks.x);
    bodies.set_flag(id.index, kLockY, locks.y);
    bodies.set_flag(id.index, kLockRotation, locks.rotation);
    impl_->update_mass(id);
}

void World::set_damping(BodyId id, float linear, float angular) {
    require_not_negative(linear, "body linear_damping");
    require_not_negative(angular, "body angular_damping");
    impl_->change_motion(id, [&](BodyMotion& motion) {
        motion.linear_damping = linear;
        motion.angular_damping = angular;
    });
}

void World::set_gravity_scale(BodyId id, float scale) {
    tumble::require_finite(scale, "body gravity_scale");
    impl_->change_motion(id, [&](BodyMotion& motion) { motion.gravity_scale = scale; });
}

void World::set_allow_sleep(BodyId id, bool allowed) {
    impl_->change_motion(id, [&](BodyMotion& motion) { motion.allow_sleep = allowed; });
}

void World::set_bullet(BodyId id, bool bullet) {
    impl_->require(id);
    wake(impl_->simulation, id.index);
    impl_->simulation.bodies.set_flag(id.index, kBulletBody, bullet);
}

void World::set_allow_fast_rotation(BodyId id, bool allowed) {
    impl_->require(id);
    wake(impl_->simulation, id.index);
    impl_->simulation.bodies.set_flag(id.index, kFastSpin, allowed);
}

void World::set_mass(BodyId id, const std::optional<BodyMass>& mass) {
    impl_->require(id);
    check(mass);
    wake(impl_->simulation, id.index);
    impl_->simulation.bodies.records[id.index].own_mass = mass;
    impl_->update_mass(id);
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
    // A kinematic body starts to move: it takes along what leans on it, and may meet what sleeps.
    wake_with_neighbors(impl_->simulation, id.index);
    impl_->touch_shapes(id);
}

void World::move_towards(BodyId id, const Pose& pose) {
    impl_->require(id);
    check_pose(pose, "body");
    const BodyFrame& frame = impl_->simulation.bodies.frames[id.index];
    const DVec2 way = transform_point(pose, impl_->simulation.bodies.records[id.index].mass.center) - frame.center;
    const double turn = relative_angle(frame.pose.rotation, pose.rotation);
    const double rate = double{impl_->def.steps_per_second};
    set_velocity(id, to_float(rate * way), static_cast<float>(rate * turn));
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
    MovingBody* const moving = impl_->wake_to_push(id);
    if (!moving) return;
    const BodyFrame& frame = impl_->simulation.bodies.frames[id.index];
    moving->acceleration += scaled(frame.inv_masses(), force);
    moving->angular_acceleration += frame.inv_inertia * cross(to_float(point - frame.center), force);
}

void World::apply_torque(BodyId id, float torque) {
    impl_->require(id);
    check_action(torque, "torque");
    MovingBody* const moving = impl_->wake_to_push(id);
    if (moving) moving->angular_acceleration += impl_->simulation.bodies.frames[id.index].inv_inertia * torque;
}

void World::apply_impulse(BodyId id, Vec2 impulse, DVec2 point) {
    impl_->require(id);
    check_action(impulse, "impulse");
    check_point(point);
    if (!impl_->wake_to_push(id)) return;
    const BodyFrame& frame = impl_->simulation.bodies.frames[id.index];
    SolverBody& body = impl_->simulation.bodies.solver_bodies[frame.solver_body];
    body.velocity += scaled(frame.inv_masses(), impulse);
    body.angular_velocity += frame.inv_inertia * cross(to_float(point - frame.center), impulse);
}

void World::apply_angular_impulse(BodyId id, float impulse) {
    impl_->require(id);
    check_action(impulse, "angular impulse");
    if (!impl_->wake_to_push(id)) return;
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
