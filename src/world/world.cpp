// The facade: what comes and goes, the step, and what a user may read.
#include "tumble/world.hpp"

#include <string>

#include "dynamics/contacts/make_contact.hpp"
#include "dynamics/stages/sleep.hpp"
#include "dynamics/step.hpp"
#include "world/contact_report.hpp"
#include "world/input_checks.hpp"
#include "world/island_numbers.hpp"
#include "world/memory.hpp"
#include "world/snapshot.hpp"
#include "world/state_hash.hpp"
#include "world/validate.hpp"
#include "world/world_impl.hpp"

namespace tumble {

ShapeId World::Impl::attach(BodyId body, const ShapeDef& shape) {
    const ShapeId id = simulation.shapes.create(body.index, shape);
    BodyRecord& record = simulation.bodies.records[body.index];
    record.shapes.push_back(id);
    if (record.is_enabled)
        simulation.shapes.place(id.index, simulation.bodies.frames[body.index], simulation.settings.tuning,
                                simulation.broad);
    return id;
}

void World::Impl::touch_shapes(BodyId id) {
    if (!simulation.bodies.records[id.index].is_enabled) return;
    for (const ShapeId shape : simulation.bodies.records[id.index].shapes) simulation.broad.touch(shape.index);
}

void World::Impl::place_shapes(BodyId id) {
    if (!simulation.bodies.records[id.index].is_enabled) return;
    for (const ShapeId shape : simulation.bodies.records[id.index].shapes)
        simulation.shapes.place(shape.index, simulation.bodies.frames[id.index], simulation.settings.tuning,
                                simulation.broad);
}

void World::Impl::displace_shapes(BodyId id) {
    for (const ShapeId shape : simulation.bodies.records[id.index].shapes)
        simulation.shapes.displace(shape.index, simulation.broad);
}

void World::Impl::update_mass(BodyId id) {
    BodyStore& bodies = simulation.bodies;
    const BodyRecord& record = bodies.records[id.index];
    const std::vector<ShapeId>& shapes = record.shapes;
    BodyMass mass;
    // Nobody asks how far a static body reaches, and one of thousands of shapes is made a shape at a time.
    if (bodies.frames[id.index].type == BodyType::static_body) return bodies.set_mass(id, mass, 0.0f, 0.0f);
    if (bodies.is_dynamic(id.index)) mass = record.own_mass ? *record.own_mass : body_mass(shapes, simulation.shapes);
    bodies.set_mass(id, mass, body_reach(mass.center, shapes, simulation.shapes),
                    smallest_extent(shapes, simulation.shapes));
}

StepCounters World::Impl::count() const {
    StepCounters counters_now;
    counters_now.bodies = static_cast<int>(simulation.bodies.ids.live().size());
    counters_now.joints = static_cast<int>(simulation.joints.ids.live().size());
    counters_now.colors = simulation.scratch.contact_solver.color_count();
    counters_now.awake_bodies = simulation.bodies.awake_dynamic_count();
    counters_now.sleeping_islands = static_cast<int>(simulation.sleeping.count());
    counters_now.contacts = static_cast<int>(simulation.contact_counts.contacts);
    counters_now.contact_points = static_cast<int>(simulation.contact_counts.points);
    counters_now.pairs = simulation.report.collided.pairs;
    counters_now.collided = simulation.report.collided.full;
    counters_now.gjk_iterations = simulation.report.collided.iterations;
    counters_now.ms = simulation.report.times;
    return counters_now;
}

void World::Impl::apply_settings() {
    simulation.settings = {def.gravity,    1.0f / def.steps_per_second, def.substeps, def.sleeping,
                           def.continuous, make_tuning(def.scale)};
}

World::World(const WorldDef& def) {
    check(def);
    impl_ = std::make_unique<Impl>();
    impl_->def = def;
    impl_->apply_settings();
}

World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

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
    // With the centre of mass its velocity has changed, if the body turns.
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

ShapeId World::add_shape(BodyId body, const ShapeDef& def) {
    impl_->require(body);
    check(def);
    Simulation& simulation = impl_->simulation;
    // A body that is being built asleep goes on sleeping; one that rests on something may no longer do so.
    const std::uint32_t island = simulation.bodies.records[body.index].island;
    if (island != kNoIsland && !simulation.sleeping[island].contacts.empty()) wake(simulation, body.index);
    const ShapeId id = impl_->attach(body, def);
    impl_->update_mass(body);
    return id;
}

void World::remove_shape(ShapeId id) {
    impl_->require(id);
    Simulation& simulation = impl_->simulation;
    const BodyId body = simulation.bodies.ids.at(simulation.shapes[id.index].body);
    wake_with_neighbors(simulation, body.index);
    std::erase(simulation.bodies.records[body.index].shapes, id);
    simulation.shapes.destroy(id, simulation.broad);
    impl_->update_mass(body);
}

void World::set_material(ShapeId id, const SurfaceMaterial& material) {
    impl_->require(id);
    check(material);
    Simulation& simulation = impl_->simulation;
    const BodyId body = simulation.bodies.ids.at(simulation.shapes[id.index].body);
    wake_with_neighbors(simulation, body.index);
    simulation.shapes.set_material(id.index, material);
    const auto mix = [&](Contact& contact) {
        const bool concerned = contact.shapes.a == id.index || contact.shapes.b == id.index;
        if (concerned && simulation.is_live(contact.shapes)) mix_surfaces(contact, simulation.shapes);
    };
    for (Contact& contact : simulation.contacts.all()) mix(contact);
    for (Contact& contact : simulation.contacts.woken()) mix(contact);
    simulation.sleeping.for_each_contact(mix);
    impl_->update_mass(body);
}

void World::set_filter(ShapeId id, const CollisionFilter& filter) {
    impl_->require(id);
    Simulation& simulation = impl_->simulation;
    const BodyId body = simulation.bodies.ids.at(simulation.shapes[id.index].body);
    wake_with_neighbors(simulation, body.index);
    wake_overlapping(simulation, body.index);
    simulation.shapes.set_filter(id.index, filter);
    impl_->touch_shapes(body);
    simulation.filters_changed = true;
}

void World::set_gravity(Vec2 gravity) {
    check_action(gravity, "gravity");
    impl_->def.gravity = impl_->simulation.settings.gravity = gravity;
    for (const BodyId id : impl_->simulation.bodies.ids.live()) wake(impl_->simulation, id.index);
}

void World::step() {
    Simulation& simulation = impl_->simulation;
    if (impl_->diverged_body == kNoBody) {
        tumble::step(simulation);
        for (const JointId id : simulation.events.broken_joints)
            if (is_valid(id)) destroy_joint(id);  // a gear may have gone with its joint
        ++impl_->step_count;
        impl_->counters = impl_->count();
        impl_->diverged_body = find_diverged(simulation.bodies);
    }
    if (impl_->diverged_body != kNoBody)
        throw SimulationDiverged(simulation.bodies.ids.at(impl_->diverged_body), impl_->step_count);
}

std::uint64_t World::step_count() const noexcept { return impl_->step_count; }
double World::time() const noexcept {
    return static_cast<double>(impl_->step_count) / double{impl_->def.steps_per_second};
}
const WorldDef& World::def() const noexcept { return impl_->def; }

bool World::is_valid(BodyId id) const noexcept { return impl_->simulation.bodies.ids.is_live(id); }
bool World::is_valid(ShapeId id) const noexcept { return impl_->simulation.shapes.ids.is_live(id); }
bool World::is_valid(JointId id) const noexcept { return impl_->simulation.joints.ids.is_live(id); }

std::span<const BodyId> World::bodies() const noexcept { return impl_->simulation.bodies.ids.live(); }
std::vector<BodyId> World::awake_bodies() const {
    const BodyStore& bodies = impl_->simulation.bodies;
    std::vector<BodyId> awake;
    for (const BodyId id : bodies.ids.live())
        if (bodies.is_active(id.index)) awake.push_back(id);
    return awake;
}

std::vector<int> World::islands() const { return find_island_numbers(impl_->simulation); }

std::span<const JointId> World::joints() const noexcept { return impl_->simulation.joints.ids.live(); }

std::span<const JointId> World::joints(BodyId id) const {
    impl_->require(id);
    return impl_->simulation.bodies.records[id.index].joints;
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

const StepEvents& World::events() const noexcept { return impl_->simulation.events; }

std::vector<ContactPoint> World::contacts() const { return report_contacts(impl_->simulation, kNoBody); }

std::vector<ContactPoint> World::contacts(BodyId id) const {
    impl_->require(id);
    return report_contacts(impl_->simulation, id.index);
}

std::vector<ShapePair> World::candidate_pairs() const { return report_pairs(impl_->simulation); }

std::uint64_t World::state_hash() const { return hash_bodies(impl_->simulation.bodies); }

const StepCounters& World::counters() const noexcept { return impl_->counters; }

WorldMemory World::memory() const { return count_memory(impl_->simulation); }

std::vector<std::byte> World::save() const {
    return write_snapshot({impl_->def, impl_->simulation, impl_->step_count, impl_->diverged_body});
}

World World::load(std::span<const std::byte> snapshot) {
    World world;
    Impl& impl = *world.impl_;
    read_snapshot(snapshot, {impl.def, impl.simulation, impl.step_count, impl.diverged_body});
    impl.apply_settings();
    impl.counters = impl.count();
    return world;
}

void World::validate() const { tumble::validate(impl_->simulation); }

SimulationDiverged::SimulationDiverged(BodyId body_, std::uint64_t step_)
    : std::runtime_error("the simulation diverged in step " + std::to_string(step_) + ": body " +
                         std::to_string(body_.index) + " is no longer finite"),
      body(body_),
      step(step_) {}

}  // namespace tumble
