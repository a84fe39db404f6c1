#include "dynamics/state/collision_rules.hpp"

#include "debug/check.hpp"
#include "dynamics/rows/joint_ends.hpp"

namespace tumble {

namespace {

// True if a joint between the two bodies excludes contacts between them.
bool joined_without_contact(const Simulation& simulation, std::uint32_t body_a, std::uint32_t body_b) {
    TUMBLE_CHECK(body_a != body_b);
    for (const JointId id : simulation.bodies.fewer_joints(body_a, body_b)) {
        const JointDef& def = simulation.joints.def(id);
        const std::uint32_t a = joint_body_a(def).index, b = joint_body_b(def).index;
        const bool connects_both = (a == body_a && b == body_b) || (a == body_b && b == body_a);
        if (connects_both && !collides_connected(def)) return true;
    }
    return false;
}

}  // namespace

bool may_touch(const Simulation& simulation, ProxyPair shapes) {
    const ShapeRecord& a = simulation.shapes[shapes.a];
    const ShapeRecord& b = simulation.shapes[shapes.b];
    return a.body != b.body && !a.is_sensor && !b.is_sensor && may_touch(a.filter, b.filter) &&
           !joined_without_contact(simulation, a.body, b.body);
}

bool is_over(const Simulation& simulation, const Contact& contact) {
    TUMBLE_CHECK(contact.shapes.a < contact.shapes.b);
    return !simulation.broad.overlap(contact.shapes) ||
           (simulation.filters_changed && !may_touch(simulation, contact.shapes));
}

bool may_collide(const Simulation& simulation, ProxyPair shapes) {
    const ShapeRecord& a = simulation.shapes[shapes.a];
    const ShapeRecord& b = simulation.shapes[shapes.b];
    TUMBLE_CHECK(shapes.a < shapes.b);
    if (!simulation.is_live(shapes)) return false;
    const BodyStore& bodies = simulation.bodies;
    if (a.is_sensor != b.is_sensor) {
        const bool both_static =
            bodies.frames[a.body].type == BodyType::static_body && bodies.frames[b.body].type == BodyType::static_body;
        return a.body != b.body && !both_static && may_touch(a.filter, b.filter);
    }
    const bool one_is_dynamic = bodies.is_dynamic(a.body) || bodies.is_dynamic(b.body);
    const bool one_is_active = bodies.is_active(a.body) || bodies.is_active(b.body);
    return one_is_dynamic && one_is_active && may_touch(simulation, shapes);
}

}  // namespace tumble
