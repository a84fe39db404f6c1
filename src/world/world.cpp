// The facade: checks what comes in, turns ids into indices, and leaves the physics to the dynamics room.
#include "tumble/world.hpp"

#include <algorithm>
#include <string>

#include "dynamics/integrate.hpp"
#include "dynamics/simulation.hpp"
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

void World::Impl::count(StepCounters& to) const {
    to = StepCounters{};
    to.bodies = static_cast<int>(simulation.bodies.ids.live().size());
    to.joints = static_cast<int>(simulation.joints.ids.live().size());
    to.colors = simulation.graph.color_count();
    for (const Contact& contact : simulation.contacts.all()) {
        to.contacts += contact.manifold.point_count > 0;
        to.contact_points += contact.manifold.point_count;
    }
    to.pairs_ms = simulation.times.pairs_ms;
    to.narrow_ms = simulation.times.narrow_ms;
    to.solve_ms = simulation.times.solve_ms;
    to.step_ms = simulation.times.total_ms;
}

World::World(const WorldDef& def) {
    check(def);
    impl_ = std::make_unique<Impl>();
    impl_->def = def;
    impl_->simulation.settings = {def.gravity, 1.0f / def.steps_per_second, def.substeps};
}

World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

BodyId World::create_body(const BodyDef& def) {
    check(def);
    Simulation& simulation = impl_->simulation;
    const BodyId id = simulation.bodies.create(def);
    simulation.bodies.set_mass(id, body_mass(def.type, {}, simulation.shapes));
    return id;
}

void World::destroy_body(BodyId id) {
    impl_->require(id);
    Simulation& simulation = impl_->simulation;
    while (!simulation.bodies.records[id.index].joints.empty())
        impl_->remove_joint(simulation.bodies.records[id.index].joints.back());
    impl_->remove_shapes(id);
    simulation.bodies.destroy(id);
}

ShapeId World::add_shape(BodyId body, const ShapeDef& def) {
    impl_->require(body);
    check(def);
    Simulation& simulation = impl_->simulation;
    const BodyFrame& frame = simulation.bodies.frames[body.index];
    const ShapeId id = simulation.shapes.create(body.index, def, frame, simulation.broad);
    std::vector<ShapeId>& shapes = simulation.bodies.records[body.index].shapes;
    shapes.push_back(id);
    simulation.bodies.set_mass(body, body_mass(frame.type, shapes, simulation.shapes));
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
    return id;
}

void World::destroy_joint(JointId id) {
    impl_->require(id);
    impl_->remove_joint(id);
}

void World::step() {
    Simulation& simulation = impl_->simulation;
    if (impl_->diverged_body == kNoBody) {
        tumble::step(simulation);
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
    const std::uint32_t index = impl_->simulation.bodies.frames[id.index].solver_body;
    if (index == kStaticSolverBody)
        throw std::invalid_argument("body " + std::to_string(id.index) + " is static: it has no velocity to set");
    SolverBody& body = impl_->simulation.bodies.solver_bodies[index];
    body.velocity = velocity;
    body.angular_velocity = angular_velocity;
}

std::span<const BodyId> World::bodies() const noexcept {
    return impl_->simulation.bodies.ids.live();
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
