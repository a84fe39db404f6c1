// Bodies: creating and destroying them, their definitions, types, locks, damping and mass.
#include "dynamics/stages/sleep.hpp"
#include "world/input_checks.hpp"
#include "world/require.hpp"
#include "world/world_impl.hpp"

namespace tumble {

namespace {

void wake_with_bodies(Simulation& simulation, JointId id) {
    for (const BodyId body : simulation.joints.bodies(id)) wake(simulation, body.index);
    wake_joint(simulation, id);
}

}  // namespace

template <class Change>
void World::Impl::change_motion(BodyId id, Change&& change) {
    require(id);
    wake(simulation, id.index);
    BodyMotion motion = simulation.bodies.records[id.index].motion;
    change(motion);
    simulation.bodies.set_motion(id.index, motion);
}

BodyId World::create_body(const BodyDef& def) {
    check(def);
    Simulation& simulation = impl_->simulation;
    const BodyId id = simulation.bodies.create(def);
    impl_->update_mass(id);
    if (!def.awake && simulation.bodies.is_dynamic(id.index)) put_new_body_to_sleep(simulation, id.index);
    return id;
}

BodyId World::create_body(const BodyDef& def, std::span<const ShapeDef> shapes) {
    for (const ShapeDef& shape : shapes) check(shape);
    const BodyId id = create_body(def);
    for (const ShapeDef& shape : shapes) impl_->attach(id, shape);
    impl_->update_mass(id);
    // The velocity of the definition is that of the centre of mass, which the shapes have moved.
    const BodyStore& bodies = impl_->simulation.bodies;
    if (bodies.is_dynamic(id.index) && bodies.is_active(id.index)) set_velocity(id, def.velocity, def.angular_velocity);
    return id;
}

void World::destroy_body(BodyId id) {
    impl_->require(id);
    Simulation& simulation = impl_->simulation;
    wake_with_neighbors(simulation, id.index);
    while (!simulation.bodies.records[id.index].joints.empty())
        impl_->remove_joint(simulation.bodies.records[id.index].joints.back());
    for (const ShapeId shape : simulation.bodies.records[id.index].shapes)
        simulation.shapes.destroy(shape, simulation.broad);
    simulation.bodies.destroy(id);
}

bool World::is_valid(BodyId id) const noexcept { return impl_->simulation.bodies.ids.is_live(id); }

std::span<const BodyId> World::bodies() const noexcept { return impl_->simulation.bodies.ids.live(); }
std::vector<BodyId> World::awake_bodies() const {
    const BodyStore& bodies = impl_->simulation.bodies;
    std::vector<BodyId> awake;
    for (const BodyId id : bodies.ids.live())
        if (bodies.is_active(id.index)) awake.push_back(id);
    return awake;
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
    def.user_data = record.user_data;
    return def;
}

std::uint64_t World::user_data(BodyId id) const {
    impl_->require(id);
    return impl_->simulation.bodies.records[id.index].user_data;
}

void World::set_user_data(BodyId id, std::uint64_t data) {
    impl_->require(id);
    impl_->simulation.bodies.records[id.index].user_data = data;
}

void World::set_type(BodyId id, BodyType type) {
    impl_->require(id);
    Simulation& simulation = impl_->simulation;
    if (type == simulation.bodies.records[id.index].type) return;
    wake_with_neighbors(simulation, id.index);
    impl_->remove_proxies(id);
    simulation.bodies.set_type(id.index, type);
    impl_->add_proxies(id);
    impl_->update_mass(id);
    simulation.filters_changed = true;  // contacts between two static bodies end
}

void World::set_enabled(BodyId id, bool enabled) {
    impl_->require(id);
    Simulation& simulation = impl_->simulation;
    BodyRecord& record = simulation.bodies.records[id.index];
    if (enabled == record.is_enabled) return;
    wake_with_neighbors(simulation, id.index);
    impl_->remove_proxies(id);
    simulation.bodies.set_enabled(id.index, enabled);
    impl_->add_proxies(id);
    impl_->update_mass(id);
    if (!enabled) simulation.joints.put_to_sleep(record.joints);
    for (const JointId joint : record.joints) wake_with_bodies(simulation, joint);
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

}  // namespace tumble
