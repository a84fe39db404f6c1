#include "dynamics/state/collision_rules.hpp"

#include "dynamics/rows/joint_ends.hpp"

namespace tumble {

namespace {

bool joined_without_contact(const Simulation& simulation, std::uint32_t body_a, std::uint32_t body_b) {
    for (const JointId id : simulation.bodies.fewer_joints(body_a, body_b)) {
        const JointDef& def = simulation.joints.def(id);
        const std::uint32_t a = joint_body_a(def).index, b = joint_body_b(def).index;
        const bool are_its_ends = (a == body_a && b == body_b) || (a == body_b && b == body_a);
        if (are_its_ends && !collides_connected(def)) return true;
    }
    return false;
}

}  // namespace

bool may_touch(const Simulation& simulation, ProxyPair shapes) {
    const ShapeRecord& a = simulation.shapes[shapes.a];
    const ShapeRecord& b = simulation.shapes[shapes.b];
    return a.body != b.body && !a.is_sensor && !b.is_sensor && may_meet(a.filter, b.filter) &&
           !joined_without_contact(simulation, a.body, b.body);
}

// Type and rest do not count: what falls asleep, or stops, still touches what it leans on.
bool is_over(const Simulation& simulation, const Contact& contact) {
    return !simulation.broad.overlap(contact.shapes) ||
           (simulation.filters_changed && !may_touch(simulation, contact.shapes));
}

bool may_collide(const Simulation& simulation, ProxyPair shapes) {
    const ShapeRecord& a = simulation.shapes[shapes.a];
    const ShapeRecord& b = simulation.shapes[shapes.b];
    if (!simulation.is_live(shapes)) return false;
    const BodyStore& bodies = simulation.bodies;
    if (a.is_sensor != b.is_sensor) {
        const bool both_static =
            bodies.frames[a.body].type == BodyType::static_body && bodies.frames[b.body].type == BodyType::static_body;
        return a.body != b.body && !both_static && may_meet(a.filter, b.filter);
    }
    const bool can_give_way = bodies.is_dynamic(a.body) || bodies.is_dynamic(b.body);
    const bool can_come_near = bodies.is_active(a.body) || bodies.is_active(b.body);
    return can_give_way && can_come_near && may_touch(simulation, shapes);
}

}  // namespace tumble
