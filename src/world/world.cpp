// The facade: checks what comes in, turns ids into indices, and leaves the physics to the dynamics room.
#include "tumble/world.hpp"

#include <algorithm>
#include <string>

#include "dynamics/integrate.hpp"
#include "dynamics/simulation.hpp"
#include "dynamics/sleep.hpp"
#include "world/contact_report.hpp"
#include "world/input_checks.hpp"
#include "world/state_hash.hpp"
#include "world/validate.hpp"

namespace tumble {

struct World::Impl {
    WorldDef def;
    Simulation simulation;
    StepCounters counters;
    std::uint64_t step_count = 0;
    std::uint32_t diverged_body = kNoBody;

    void require(BodyId id) const { require_live(simulation.bodies.ids, id, "body"); }
    void require(ShapeId id) const { require_live(simulation.shapes.ids, id, "shape"); }
    void require(JointId id) const { require_live(simulation.joints.ids, id, "joint"); }

    void remove_joint(JointId id);
    void remove_shapes(BodyId id);
    void touch_shapes(BodyId id);
    void update_mass(BodyId id);
    void tie(JointId id, std::uint32_t body_a, std::uint32_t body_b);
    MovingBody* wake_to_push(BodyId id);
    void count(StepCounters& counters) const;

private:
    template <class IdType>
    static void require_live(const IdPool<IdType>& pool, IdType id, const char* kind) {
        if (pool.is_live(id)) return;
        throw std::invalid_argument(std::string(kind) + " id is stale or foreign: index " + std::to_string(id.index) +
                                    ", generation " + std::to_string(id.generation));
    }
};

void World::Impl::touch_shapes(BodyId id) {
    for (const ShapeId shape : simulation.bodies.records[id.index].shapes) simulation.broad.touch(shape.index);
}

void World::Impl::remove_joint(JointId id) {
    const JointDef& joint = simulation.joints.def(id);
    for (const BodyId body : {joint_body_a(joint), joint_body_b(joint)}) {
        std::erase(simulation.bodies.records[body.index].joints, id);
        touch_shapes(body);  // pairs that the joint forbade may come back
    }
    simulation.joints.destroy(id);
}

void World::Impl::remove_shapes(BodyId id) {
    for (const ShapeId shape : simulation.bodies.records[id.index].shapes)
        simulation.shapes.destroy(shape, simulation.broad);
}

void World::Impl::update_mass(BodyId id) {
    BodyStore& bodies = simulation.bodies;
    const std::vector<ShapeId>& shapes = bodies.records[id.index].shapes;
    const BodyMass mass = body_mass(bodies.frames[id.index].type, shapes, simulation.shapes);
    bodies.set_mass(id, mass, body_reach(mass.center, shapes, simulation.shapes),
                    smallest_extent(shapes, simulation.shapes));
}

// What a new joint does to sleepers: a joint among them sleeps with them, any other wakes them.
void World::Impl::tie(JointId id, std::uint32_t body_a, std::uint32_t body_b) {
    const BodyStore& bodies = simulation.bodies;
    const bool sleeps_a = bodies.is_asleep(body_a), sleeps_b = bodies.is_asleep(body_b);
    if (bodies.is_active(body_a) || bodies.is_active(body_b)) {
        wake(simulation, body_a);
        wake(simulation, body_b);
    } else if (sleeps_a || sleeps_b) {
        if (sleeps_a && sleeps_b) merge_sleeping_islands(simulation, body_a, body_b);
        simulation.joints.put_to_sleep({&id, 1});
    }
}

// The body awake, or nullptr if it is not dynamic.
MovingBody* World::Impl::wake_to_push(BodyId id) {
    if (!simulation.bodies.is_dynamic(id.index)) return nullptr;
    wake(simulation, id.index);
    return &simulation.bodies.moving[simulation.bodies.frames[id.index].solver_body];
}

void World::Impl::count(StepCounters& to) const {
    to = StepCounters{};
    to.bodies = static_cast<int>(simulation.bodies.ids.live().size());
    to.joints = static_cast<int>(simulation.joints.ids.live().size());
    to.colors = simulation.graph.color_count();
    to.awake_bodies = simulation.bodies.awake_dynamic_count();
    to.sleeping_islands = static_cast<int>(simulation.sleeping.count());
    to.contacts = static_cast<int>(simulation.contact_counts.contacts);
    to.contact_points = static_cast<int>(simulation.contact_counts.points);
    to.pairs_ms = simulation.times.pairs_ms;
    to.narrow_ms = simulation.times.narrow_ms;
    to.solve_ms = simulation.times.solve_ms;
    to.step_ms = simulation.times.total_ms;
}

World::World(const WorldDef& def) {
    check(def);
    impl_ = std::make_unique<Impl>();
    impl_->def = def;
    impl_->simulation.settings = {def.gravity, 1.0f / def.steps_per_second, def.substeps, def.sleeping, def.continuous};
}

World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

BodyId World::create_body(const BodyDef& def) {
    check(def);
    Simulation& simulation = impl_->simulation;
    const BodyId id = simulation.bodies.create(def);
    impl_->update_mass(id);
    if (!def.awake && def.type == BodyType::dynamic_body) put_new_body_to_sleep(simulation, id.index);
    return id;
}

void World::destroy_body(BodyId id) {
    impl_->require(id);
    Simulation& simulation = impl_->simulation;
    wake_with_neighbors(simulation, id.index);
    while (!simulation.bodies.records[id.index].joints.empty())
        impl_->remove_joint(simulation.bodies.records[id.index].joints.back());
    impl_->remove_shapes(id);
    simulation.bodies.destroy(id);
}

ShapeId World::add_shape(BodyId body, const ShapeDef& def) {
    impl_->require(body);
    check(def);
    Simulation& simulation = impl_->simulation;
    // A body that is being built asleep goes on sleeping; one that rests on something may no longer do so.
    const std::uint32_t island = simulation.bodies.records[body.index].island;
    if (island != kNoIsland && !simulation.sleeping[island].contacts.empty()) wake(simulation, body.index);
    const BodyFrame& frame = simulation.bodies.frames[body.index];
    const ShapeId id = simulation.shapes.create(body.index, def, frame, simulation.broad);
    simulation.bodies.records[body.index].shapes.push_back(id);
    impl_->update_mass(body);
    return id;
}

JointId World::create_joint(const JointDef& def) {
    const BodyId a = joint_body_a(def), b = joint_body_b(def);
    impl_->require(a);
    impl_->require(b);
    if (a == b) throw std::invalid_argument("joint needs two bodies, got body " + std::to_string(a.index) + " twice");
    check(def);
    Simulation& simulation = impl_->simulation;
    const JointId id = simulation.joints.create(def);
    simulation.bodies.records[a.index].joints.push_back(id);
    simulation.bodies.records[b.index].joints.push_back(id);
    simulation.filters_changed |= !collides_connected(def);
    impl_->tie(id, a.index, b.index);
    return id;
}

void World::set_joint(JointId id, const JointDef& def) {
    impl_->require(id);
    Simulation& simulation = impl_->simulation;
    const JointDef& old = simulation.joints.def(id);
    if (def.index() != old.index() || joint_body_a(def) != joint_body_a(old) || joint_body_b(def) != joint_body_b(old))
        throw std::invalid_argument("joint " + std::to_string(id.index) + " must keep its kind and its bodies");
    check(def);
    for (const BodyId body : {joint_body_a(def), joint_body_b(def)}) {
        wake(simulation, body.index);
        impl_->touch_shapes(body);
    }
    simulation.filters_changed |= !collides_connected(def);
    simulation.joints.redefine(id, def);
}

void World::destroy_joint(JointId id) {
    impl_->require(id);
    const JointDef& joint = impl_->simulation.joints.def(id);
    for (const BodyId body : {joint_body_a(joint), joint_body_b(joint)}) wake(impl_->simulation, body.index);
    impl_->remove_joint(id);
}

void World::step() {
    Simulation& simulation = impl_->simulation;
    if (impl_->diverged_body == kNoBody) {
        tumble::step(simulation);
        for (const JointId id : simulation.events.broken_joints) destroy_joint(id);
        ++impl_->step_count;
        impl_->count(impl_->counters);
        impl_->diverged_body = find_diverged(simulation.bodies);
    }
    if (impl_->diverged_body != kNoBody)
        throw SimulationDiverged(simulation.bodies.ids.at(impl_->diverged_body), impl_->step_count);
}

std::uint64_t World::step_count() const noexcept {
    return impl_->step_count;
}
const WorldDef& World::def() const noexcept {
    return impl_->def;
}

bool World::is_valid(BodyId id) const noexcept {
    return impl_->simulation.bodies.ids.is_live(id);
}
bool World::is_valid(ShapeId id) const noexcept {
    return impl_->simulation.shapes.ids.is_live(id);
}
bool World::is_valid(JointId id) const noexcept {
    return impl_->simulation.joints.ids.is_live(id);
}

BodyType World::type(BodyId id) const {
    impl_->require(id);
    return impl_->simulation.bodies.frames[id.index].type;
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

void World::set_velocity(BodyId id, Vec2 velocity, float angular_velocity) {
    impl_->require(id);
    check_velocity(velocity, angular_velocity);
    BodyStore& bodies = impl_->simulation.bodies;
    if (bodies.frames[id.index].type == BodyType::static_body)
        throw std::invalid_argument("body " + std::to_string(id.index) + " is static: it has no velocity to set");
    if (bodies.is_dynamic(id.index)) wake(impl_->simulation, id.index);
    const bool was_active = bodies.is_active(id.index);
    SolverBody& body = bodies.solver_bodies[bodies.frames[id.index].solver_body];
    body.velocity = velocity;
    body.angular_velocity = angular_velocity;
    if (was_active || !bodies.is_active(id.index)) return;
    // A kinematic body starts to move: it takes along what leans on it, and may meet what sleeps.
    wake_with_neighbors(impl_->simulation, id.index);
    impl_->touch_shapes(id);
}

void World::apply_force(BodyId id, Vec2 force, DVec2 point) {
    impl_->require(id);
    check_action(force, "force");
    check_point(point);
    MovingBody* const moving = impl_->wake_to_push(id);
    if (!moving) return;
    const BodyFrame& frame = impl_->simulation.bodies.frames[id.index];
    moving->acceleration += frame.inv_mass * force;
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
    body.velocity += frame.inv_mass * impulse;
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

std::span<const BodyId> World::bodies() const noexcept {
    return impl_->simulation.bodies.ids.live();
}
std::vector<BodyId> World::awake_bodies() const {
    const BodyStore& bodies = impl_->simulation.bodies;
    std::vector<BodyId> awake;
    for (const BodyId id : bodies.ids.live())
        if (bodies.is_active(id.index)) awake.push_back(id);
    return awake;
}

std::span<const JointId> World::joints() const noexcept {
    return impl_->simulation.joints.ids.live();
}

std::span<const ShapeId> World::shapes(BodyId id) const {
    impl_->require(id);
    return impl_->simulation.bodies.records[id.index].shapes;
}

const Shape& World::shape(ShapeId id) const {
    impl_->require(id);
    return impl_->simulation.shapes[id.index].shape;
}

const SurfaceMaterial& World::material(ShapeId id) const {
    impl_->require(id);
    return impl_->simulation.shapes[id.index].material;
}

const CollisionFilter& World::filter(ShapeId id) const {
    impl_->require(id);
    return impl_->simulation.shapes[id.index].filter;
}

bool World::is_sensor(ShapeId id) const {
    impl_->require(id);
    return impl_->simulation.shapes[id.index].is_sensor;
}

BodyId World::body(ShapeId id) const {
    impl_->require(id);
    return impl_->simulation.bodies.ids.at(impl_->simulation.shapes[id.index].body);
}

const JointDef& World::joint(JointId id) const {
    impl_->require(id);
    return impl_->simulation.joints.def(id);
}

JointReaction World::reaction(JointId id) const {
    impl_->require(id);
    return impl_->simulation.joints.reaction(id);
}

float World::joint_position(JointId id) const {
    impl_->require(id);
    return impl_->simulation.joints.position(id);
}

const StepEvents& World::events() const noexcept {
    return impl_->simulation.events;
}

std::vector<ContactPoint> World::contacts() const {
    return report_contacts(impl_->simulation);
}

std::vector<ShapePair> World::candidate_pairs() const {
    return report_pairs(impl_->simulation);
}

std::uint64_t World::state_hash() const {
    return hash_bodies(impl_->simulation.bodies);
}

const StepCounters& World::counters() const noexcept {
    return impl_->counters;
}

void World::validate() const {
    tumble::validate(impl_->simulation);
}

SimulationDiverged::SimulationDiverged(BodyId body_, std::uint64_t step_)
    : std::runtime_error("the simulation diverged in step " + std::to_string(step_) + ": body " +
                         std::to_string(body_.index) + " is no longer finite"),
      body(body_),
      step(step_) {}

}  // namespace tumble
