#include "dynamics/body_store.hpp"

namespace tumble {

BodyId BodyStore::create(const BodyDef& def) {
    const BodyId id = ids.acquire();
    if (id.index == frames.size()) {
        frames.emplace_back();
        records.emplace_back();
    }
    BodyFrame& frame = frames[id.index];
    frame = BodyFrame{};
    frame.pose = def.pose;
    frame.center = def.pose.position;
    frame.type = def.type;
    BodyRecord& record = records[id.index];
    record = BodyRecord{};
    record.motion = {def.gravity_scale, def.linear_damping, def.angular_damping, 0.0f, 0.0f, def.allow_sleep};
    if (def.type == BodyType::dynamic_body) record.flags |= kDynamicBody;
    if (def.allow_fast_rotation) record.flags |= kUnlimitedSpin;
    if (def.bullet) record.flags |= kBulletBody;
    if (def.type != BodyType::static_body) add_solver_body(id.index, def.velocity, def.angular_velocity);
    return id;
}

void BodyStore::add_solver_body(std::uint32_t body, Vec2 velocity, float angular_velocity) {
    frames[body].solver_body = static_cast<std::uint32_t>(solver_bodies.size());
    SolverBody added;
    added.velocity = velocity;
    added.angular_velocity = angular_velocity;
    added.flags = records[body].flags;
    solver_bodies.push_back(added);
    MovingBody motion;
    motion.body = body;
    motion.motion = records[body].motion;
    moving.push_back(motion);
    awake_dynamic_count_ += is_dynamic(body);
}

void BodyStore::remove_solver_body(std::uint32_t body) {
    const std::uint32_t gap = frames[body].solver_body;
    solver_bodies[gap] = solver_bodies.back();
    moving[gap] = moving.back();
    frames[moving[gap].body].solver_body = gap;
    solver_bodies.pop_back();
    moving.pop_back();
    frames[body].solver_body = kStaticSolverBody;
    awake_dynamic_count_ -= is_dynamic(body);
}

void BodyStore::put_to_sleep(std::uint32_t body) {
    remove_solver_body(body);
}

void BodyStore::wake(std::uint32_t body) {
    add_solver_body(body, {}, 0.0f);
}

bool BodyStore::is_active(std::uint32_t body) const {
    const std::uint32_t index = frames[body].solver_body;
    if (index == kStaticSolverBody) return false;
    const SolverBody& moved = solver_bodies[index];
    return is_dynamic(body) || moved.velocity != Vec2{} || moved.angular_velocity != 0.0f;
}

void BodyStore::destroy(BodyId id) {
    if (frames[id.index].solver_body != kStaticSolverBody) remove_solver_body(id.index);
    frames[id.index] = BodyFrame{};
    records[id.index] = BodyRecord{};
    ids.release(id);
    ids.recycle(id.index);
}

void BodyStore::set_mass(BodyId id, const BodyMass& mass, float reach, float smallest_extent) {
    BodyFrame& frame = frames[id.index];
    records[id.index].mass = mass;
    records[id.index].motion.reach = reach;
    records[id.index].motion.smallest_extent = smallest_extent;
    const Vec2 old_offset = frame.center_offset;
    frame.center_offset = rotate(frame.pose.rotation, mass.center);
    frame.center = transform_point(frame.pose, mass.center);
    frame.inv_mass = mass.mass > 0.0f ? 1.0f / mass.mass : 0.0f;
    frame.inv_inertia = mass.inertia > 0.0f ? 1.0f / mass.inertia : 0.0f;
    if (frame.solver_body == kStaticSolverBody) return;
    moving[frame.solver_body].motion = records[id.index].motion;
    SolverBody& body = solver_bodies[frame.solver_body];
    body.velocity += cross(body.angular_velocity, frame.center_offset - old_offset);
}

}  // namespace tumble
