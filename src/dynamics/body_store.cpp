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
    records[id.index] = BodyRecord{};
    if (def.type == BodyType::static_body) return id;

    frame.solver_body = static_cast<std::uint32_t>(solver_bodies.size());
    SolverBody body;
    body.velocity = def.velocity;
    body.angular_velocity = def.angular_velocity;
    if (def.type == BodyType::dynamic_body) body.flags |= kDynamicBody;
    if (def.allow_fast_rotation) body.flags |= kUnlimitedSpin;
    solver_bodies.push_back(body);
    moving.push_back({id.index, def.gravity_scale, def.linear_damping, def.angular_damping});
    return id;
}

void BodyStore::destroy(BodyId id) {
    const std::uint32_t gap = frames[id.index].solver_body;
    if (gap != kStaticSolverBody) {
        solver_bodies[gap] = solver_bodies.back();
        moving[gap] = moving.back();
        frames[moving[gap].body].solver_body = gap;
        solver_bodies.pop_back();
        moving.pop_back();
    }
    frames[id.index] = BodyFrame{};
    records[id.index] = BodyRecord{};
    ids.release(id);
    ids.recycle(id.index);
}

void BodyStore::set_mass(BodyId id, const BodyMass& mass) {
    BodyFrame& frame = frames[id.index];
    records[id.index].mass = mass;
    const Vec2 old_offset = frame.center_offset;
    frame.center_offset = rotate(frame.pose.rotation, mass.center);
    frame.center = transform_point(frame.pose, mass.center);
    frame.inv_mass = mass.mass > 0.0f ? 1.0f / mass.mass : 0.0f;
    frame.inv_inertia = mass.inertia > 0.0f ? 1.0f / mass.inertia : 0.0f;
    if (frame.solver_body == kStaticSolverBody) return;
    SolverBody& body = solver_bodies[frame.solver_body];
    body.velocity += cross(body.angular_velocity, frame.center_offset - old_offset);
}

}  // namespace tumble
