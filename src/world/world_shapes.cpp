// Shapes: adding and removing them, their surfaces and their filters.
#include "dynamics/contacts/make_contact.hpp"
#include "dynamics/stages/sleep.hpp"
#include "world/input_checks.hpp"
#include "world/world_impl.hpp"

namespace tumble {

ShapeId World::add_shape(BodyId body, const ShapeDef& def) {
    impl_->require(body);
    check(def);
    Simulation& simulation = impl_->simulation;
    // A body that was created asleep stays asleep while it gets its shapes. A body whose island has contacts wakes,
    // because the new shape may unbalance it.
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
        const bool has_shape = contact.shapes.a == id.index || contact.shapes.b == id.index;
        if (has_shape && simulation.is_live(contact.shapes)) mix_surfaces(contact, simulation.shapes);
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
    impl_->touch_proxies(body);
    simulation.filters_changed = true;
}

bool World::is_valid(ShapeId id) const noexcept { return impl_->simulation.shapes.ids.is_live(id); }

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

std::uint64_t World::user_data(ShapeId id) const {
    impl_->require(id);
    return impl_->simulation.shapes[id.index].user_data;
}

void World::set_user_data(ShapeId id, std::uint64_t data) {
    impl_->require(id);
    impl_->simulation.shapes.set_user_data(id.index, data);
}

}  // namespace tumble
