// Operations that the members of World share: on the shapes of a body and their proxies, mass, and removal of joints.
#include "world/world_impl.hpp"

#include "dynamics/rows/joint_ends.hpp"
#include "dynamics/stages/sleep.hpp"

namespace tumble {

ShapeId World::Impl::attach(BodyId body, const ShapeDef& shape) {
    const ShapeId id = simulation.shapes.create(body.index, shape);
    BodyRecord& record = simulation.bodies.records[body.index];
    record.shapes.push_back(id);
    if (has_place(body))
        simulation.shapes.place(id.index, simulation.bodies.frames[body.index], simulation.settings.tuning,
                                simulation.broad);
    return id;
}

bool World::Impl::has_place(BodyId id) const {
    return simulation.bodies.records[id.index].is_enabled && has_finite_pose(simulation.bodies, id.index);
}

void World::Impl::touch_proxies(BodyId id) {
    for (const ShapeId shape : simulation.bodies.records[id.index].shapes)
        if (simulation.broad.has(shape.index)) simulation.broad.touch(shape.index);
}

void World::Impl::add_proxies(BodyId id) {
    if (!has_place(id)) return;
    for (const ShapeId shape : simulation.bodies.records[id.index].shapes)
        simulation.shapes.place(shape.index, simulation.bodies.frames[id.index], simulation.settings.tuning,
                                simulation.broad);
}

void World::Impl::remove_proxies(BodyId id) {
    for (const ShapeId shape : simulation.bodies.records[id.index].shapes)
        simulation.shapes.displace(shape.index, simulation.broad);
}

void World::Impl::update_mass(BodyId id) {
    BodyStore& bodies = simulation.bodies;
    BodyRecord& record = bodies.records[id.index];
    const std::vector<ShapeId>& shapes = record.shapes;
    BodyMass mass;
    record.motion.only_shape = shapes.size() == 1 ? shapes[0].index : kNoShape;
    if (!record.joints.empty()) simulation.joints.forget_groups();
    // A static body needs neither mass nor reach. Without this line, adding n shapes to it one by one would be O(n^2).
    if (bodies.frames[id.index].type == BodyType::static_body) return bodies.set_mass(id, mass, 0.0f, 0.0f);
    if (bodies.is_dynamic(id.index)) mass = record.own_mass ? *record.own_mass : body_mass(shapes, simulation.shapes);
    bodies.set_mass(id, mass, body_reach(mass.center, shapes, simulation.shapes),
                    smallest_extent(shapes, simulation.shapes));
}

std::vector<JointId> World::Impl::gears_on(JointId id) const {
    const JointDef& joint = simulation.joints.def(id);
    std::vector<JointId> gears;
    for (const JointId other : simulation.bodies.fewer_joints(joint_body_a(joint).index, joint_body_b(joint).index)) {
        const auto* gear = std::get_if<GearJointDef>(&simulation.joints.def(other));
        if (gear && (gear->joint_a == id || gear->joint_b == id)) gears.push_back(other);
    }
    return gears;
}

void World::Impl::remove_joint(JointId id) {
    for (const JointId gear : gears_on(id)) remove_joint(gear);
    for (const BodyId body : simulation.joints.bodies(id)) {
        std::erase(simulation.bodies.records[body.index].joints, id);
        touch_proxies(body);  // the joint may have kept their shapes from colliding
    }
    simulation.joints.destroy(id);
}

void World::Impl::destroy_joint(JointId id) {
    for (const BodyId body : simulation.joints.bodies(id)) wake(simulation, body.index);
    remove_joint(id);
}

}  // namespace tumble
