#include "dynamics/bodies/body_store.hpp"

#include <algorithm>
#include <limits>

#include "debug/check.hpp"

namespace tumble {

namespace {

// 1 / x, and 0 for 0. A value too small for a finite inverse has the largest finite one.
float inverse_of(float x) { return x > 0.0f ? 1.0f / std::max(x, std::numeric_limits<float>::min()) : 0.0f; }

}  // namespace

BodyId BodyStore::create(const BodyDef& def) {
    const BodyId id = ids.acquire();
    if (id.index == frames.size()) {
        frames.emplace_back();
        records.emplace_back();
    }
    TUMBLE_CHECK(frames.size() == records.size());
    TUMBLE_CHECK(id.index < frames.size());
    BodyFrame& frame = frames[id.index];
    frame = BodyFrame{};
    frame.pose = def.pose;
    frame.center = def.pose.position;
    BodyRecord& record = records[id.index];
    record = BodyRecord{};
    record.own_mass = def.mass;
    record.type = def.type;
    record.is_enabled = def.enabled;
    record.user_data = def.user_data;
    record.motion = {def.gravity_scale, def.linear_damping, def.angular_damping, 0.0f, 0.0f, {}, def.allow_sleep};
    if (def.allow_fast_rotation) record.flags |= kFastSpin;
    if (def.bullet) record.flags |= kBulletBody;
    if (def.locks.x) record.flags |= kLockX;
    if (def.locks.y) record.flags |= kLockY;
    if (def.locks.rotation) record.flags |= kLockRotation;
    place(id.index, def.enabled ? def.type : BodyType::static_body, def.velocity, def.angular_velocity);
    return id;
}

// Gives a body without a solver body the type that it is simulated as.
void BodyStore::place(std::uint32_t body, BodyType type, Vec2 velocity, float angular_velocity) {
    TUMBLE_CHECK(frames[body].solver_body == kStaticSolverBody);
    frames[body].type = type;
    std::uint32_t& flags = records[body].flags;
    flags = type == BodyType::dynamic_body ? flags | kDynamicBody : flags & ~kDynamicBody;
    if (type != BodyType::static_body) add_solver_body(body, velocity, angular_velocity);
}

void BodyStore::set_type(std::uint32_t body, BodyType type) {
    TUMBLE_CHECK(body < records.size());
    records[body].type = type;
    if (!records[body].is_enabled) return;
    const SolverBody old = solver_bodies[frames[body].solver_body];
    if (frames[body].solver_body != kStaticSolverBody) remove_solver_body(body);
    place(body, type, old.velocity, old.angular_velocity);
}

void BodyStore::set_enabled(std::uint32_t body, bool enabled) {
    TUMBLE_CHECK(body < records.size());
    records[body].is_enabled = enabled;
    if (frames[body].solver_body != kStaticSolverBody) remove_solver_body(body);
    place(body, enabled ? records[body].type : BodyType::static_body, {}, 0.0f);
}

void BodyStore::set_flag(std::uint32_t body, BodyFlag flag, bool value) {
    TUMBLE_CHECK(body < records.size());
    std::uint32_t& flags = records[body].flags;
    flags = value ? flags | flag : flags & ~flag;
    apply_flags(body);
}

// Locks act on dynamic bodies only.
void BodyStore::apply_flags(std::uint32_t body) {
    constexpr std::uint32_t kLocks = kLockX | kLockY | kLockRotation;
    const std::uint32_t flags = is_dynamic(body) ? records[body].flags : records[body].flags & ~kLocks;
    frames[body].locks_x = (flags & kLockX) != 0;
    frames[body].locks_y = (flags & kLockY) != 0;
    if (frames[body].solver_body == kStaticSolverBody) return;
    TUMBLE_CHECK(moving[frames[body].solver_body].body == body);
    SolverBody& solved = solver_bodies[frames[body].solver_body];
    solved.flags = flags;
    solved.velocity = allowed(flags, solved.velocity);
    solved.angular_velocity = allowed(flags, solved.angular_velocity);
}

void BodyStore::set_motion(std::uint32_t body, const BodyMotion& motion) {
    TUMBLE_CHECK(motion.linear_damping >= 0.0f);
    TUMBLE_CHECK(motion.angular_damping >= 0.0f);
    records[body].motion = motion;
    if (frames[body].solver_body != kStaticSolverBody) moving[frames[body].solver_body].motion = motion;
}

void BodyStore::set_pose(std::uint32_t body, const Pose& pose) {
    TUMBLE_CHECK(body < frames.size());
    BodyFrame& frame = frames[body];
    frame.pose = pose;
    frame.center_offset = rotate(pose.rotation, records[body].mass.center);
    frame.center = transform_point(pose, records[body].mass.center);
}

void BodyStore::add_solver_body(std::uint32_t body, Vec2 velocity, float angular_velocity) {
    TUMBLE_CHECK(frames[body].solver_body == kStaticSolverBody);
    TUMBLE_CHECK(solver_bodies.size() == moving.size());
    frames[body].solver_body = static_cast<std::uint32_t>(solver_bodies.size());
    SolverBody added;
    added.velocity = velocity;
    added.angular_velocity = angular_velocity;
    solver_bodies.push_back(added);
    MovingBody motion;
    motion.body = body;
    motion.motion = records[body].motion;
    moving.push_back(motion);
    apply_flags(body);
    awake_dynamic_count_ += is_dynamic(body);
}

void BodyStore::remove_solver_body(std::uint32_t body) {
    const std::uint32_t gap = frames[body].solver_body;
    TUMBLE_CHECK(gap != kStaticSolverBody);
    TUMBLE_CHECK(gap < solver_bodies.size());
    TUMBLE_CHECK(moving[gap].body == body);
    solver_bodies[gap] = solver_bodies.back();
    moving[gap] = moving.back();
    frames[moving[gap].body].solver_body = gap;
    solver_bodies.pop_back();
    moving.pop_back();
    frames[body].solver_body = kStaticSolverBody;
    awake_dynamic_count_ -= is_dynamic(body);
    TUMBLE_CHECK(awake_dynamic_count_ >= 0);
}

void BodyStore::put_to_sleep(std::uint32_t body) {
    TUMBLE_CHECK(is_dynamic(body));
    remove_solver_body(body);
}

void BodyStore::wake(std::uint32_t body) {
    TUMBLE_CHECK(is_asleep(body));
    add_solver_body(body, {}, 0.0f);
}

void BodyStore::reorder(std::span<const std::uint32_t> order) {
    TUMBLE_CHECK(order.size() == solver_bodies.size());
    TUMBLE_CHECK(order[0] == kStaticSolverBody);
    const std::vector<SolverBody> old_bodies = solver_bodies;
    const std::vector<MovingBody> old_moving = moving;
    for (std::uint32_t i = kStaticSolverBody + 1; i < order.size(); ++i) {
        TUMBLE_CHECK(order[i] < old_bodies.size());
        solver_bodies[i] = old_bodies[order[i]];
        moving[i] = old_moving[order[i]];
        frames[moving[i].body].solver_body = i;
    }
}

bool BodyStore::is_active(std::uint32_t body) const {
    const std::uint32_t index = frames[body].solver_body;
    if (index == kStaticSolverBody) return false;
    TUMBLE_CHECK(index < solver_bodies.size());
    const SolverBody& moved = solver_bodies[index];
    return is_dynamic(body) || moved.velocity != Vec2{} || moved.angular_velocity != 0.0f;
}

void BodyStore::destroy(BodyId id) {
    TUMBLE_CHECK(ids.is_live(id));
    TUMBLE_CHECK(records[id.index].joints.empty());
    if (frames[id.index].solver_body != kStaticSolverBody) remove_solver_body(id.index);
    frames[id.index] = BodyFrame{};
    records[id.index] = BodyRecord{};
    ids.release(id);
    ids.recycle(id.index);
}

void BodyStore::set_mass(BodyId id, const BodyMass& mass, float reach, float smallest_extent) {
    TUMBLE_CHECK((mass.mass > 0.0f) == is_dynamic(id.index));
    TUMBLE_CHECK(reach >= 0.0f);
    BodyFrame& frame = frames[id.index];
    records[id.index].mass = mass;
    records[id.index].motion.mass_center = mass.center;
    records[id.index].motion.reach = reach;
    records[id.index].motion.smallest_extent = smallest_extent;
    const Vec2 old_offset = frame.center_offset;
    set_pose(id.index, frame.pose);
    frame.inv_mass = inverse_of(mass.mass);
    const bool turns = mass.inertia > 0.0f && !(records[id.index].flags & kLockRotation);
    frame.inv_inertia = turns ? inverse_of(mass.inertia) : 0.0f;
    if (frame.solver_body == kStaticSolverBody) return;
    moving[frame.solver_body].motion = records[id.index].motion;
    SolverBody& body = solver_bodies[frame.solver_body];
    body.velocity += cross(body.angular_velocity, frame.center_offset - old_offset);
    apply_flags(id.index);
}

}  // namespace tumble
