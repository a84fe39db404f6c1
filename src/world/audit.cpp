#include "world/audit.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "dynamics/contacts/contact_block.hpp"

namespace tumble {

namespace {

void require(bool holds, const char* invariant, std::size_t index) {
    if (!holds) throw std::logic_error("world: " + std::string(invariant) + " (index " + std::to_string(index) + ")");
}

void audit_bodies(const BodyStore& bodies) {
    require(bodies.moving.size() == bodies.solver_bodies.size(), "solver bodies have no partner", bodies.moving.size());
    require(bodies.solver_bodies[kStaticSolverBody].velocity == Vec2{}, "the static body moves", 0);
    std::size_t moving = 1;
    for (const BodyId id : bodies.ids.live()) {
        const BodyFrame& frame = bodies.frames[id.index];
        const bool sleeps = bodies.records[id.index].island != kNoIsland;
        const bool at_rest = frame.type == BodyType::static_body || sleeps;
        require(!sleeps || bodies.is_dynamic(id.index), "a body sleeps that cannot", id.index);
        require(at_rest == (frame.solver_body == kStaticSolverBody), "a body is moved that must not be", id.index);
        require((frame.inv_mass > 0.0f) == bodies.is_dynamic(id.index), "a mass does not fit the type", id.index);
        require(bodies.records[id.index].is_enabled || at_rest, "a disabled body moves", id.index);
        if (at_rest) continue;
        ++moving;
        require(frame.solver_body < bodies.moving.size(), "a solver body is out of range", id.index);
        require(bodies.moving[frame.solver_body].body == id.index, "a solver body belongs to another", id.index);
    }
    require(moving == bodies.moving.size(), "solver bodies are not those of the moving bodies", moving);
}

void audit_shapes(const Simulation& simulation) {
    std::size_t owned = 0;
    for (const BodyId body : simulation.bodies.ids.live()) {
        for (const ShapeId id : simulation.bodies.records[body.index].shapes) {
            ++owned;
            require(simulation.shapes.ids.is_live(id), "a body has a shape that is gone", body.index);
            require(simulation.shapes[id.index].body == body.index, "a shape belongs to another body", id.index);
            require(simulation.shapes[id.index].is_placed == simulation.bodies.records[body.index].is_enabled,
                    "a shape is met that must not be, or is not", id.index);
            if (!simulation.shapes[id.index].is_placed) continue;
            const Aabb box = bounds(simulation.shapes[id.index].shape, simulation.bodies.frames[body.index].pose);
            require(contains(simulation.broad.box(id.index), box), "a proxy's box does not hold its shape", id.index);
        }
    }
    require(owned == simulation.shapes.ids.live().size(), "shapes without a body", owned);
}

void audit_gear(const JointStore& joints, JointId id, const GearJointDef& gear) {
    require(gear.joint_a != gear.joint_b, "a gear is on one joint twice", id.index);
    for (const JointId joint : {gear.joint_a, gear.joint_b}) {
        require(joints.ids.is_live(joint), "a gear is on a joint that is gone", id.index);
        require(can_be_geared(joints.def(joint)), "a gear is on a joint of another kind", id.index);
    }
    require(
        gear.body_a == joint_body_b(joints.def(gear.joint_a)) && gear.body_b == joint_body_b(joints.def(gear.joint_b)),
        "a gear names other bodies than its joints", id.index);
}

void audit_joints(const Simulation& simulation) {
    std::size_t tied = 0;
    for (const JointId id : simulation.joints.ids.live()) {
        if (const auto* gear = std::get_if<GearJointDef>(&simulation.joints.def(id)))
            audit_gear(simulation.joints, id, *gear);
        for (const BodyId body : simulation.joints.bodies(id)) {
            ++tied;
            require(simulation.bodies.ids.is_live(body), "a joint holds a body that is gone", id.index);
            const std::vector<JointId>& joints = simulation.bodies.records[body.index].joints;
            require(std::count(joints.begin(), joints.end(), id) == 1, "a body does not know its joint", id.index);
        }
    }
    std::size_t listed = 0;
    for (const BodyId body : simulation.bodies.ids.live())
        listed += simulation.bodies.records[body.index].joints.size();
    require(listed == tied, "bodies list joints that are gone", listed);
}

void audit_islands(const Simulation& simulation) {
    const BodyStore& bodies = simulation.bodies;
    std::size_t listed = 0, count = 0, sleepers = 0;
    for (std::size_t i = 0; i < simulation.sleeping.all().size(); ++i) {
        const SleepingIsland& island = simulation.sleeping.all()[i];
        listed += island.bodies.size();
        count += !island.bodies.empty();
        require(std::is_sorted(island.bodies.begin(), island.bodies.end()), "an island is out of order", i);
        for (const std::uint32_t body : island.bodies)
            require(bodies.records[body].island == i, "a sleeper does not know its island", body);
        for (const Contact& contact : island.contacts) {
            require(contact.manifold.point_count > 0, "a contact sleeps that does not touch", i);
            require(bodies.records[contact.body_a].island == i || bodies.records[contact.body_b].island == i,
                    "a contact sleeps among others", i);
            require(simulation.broad.knows(contact.shapes), "a sleeping contact's pair is not known", i);
        }
    }
    require(count == simulation.sleeping.count(), "empty islands", count);
    for (const BodyId id : bodies.ids.live()) sleepers += bodies.is_asleep(id.index);
    require(listed == sleepers, "sleepers without an island", sleepers);
    for (const JointId id : simulation.joints.ids.live()) {
        bool rests = false;
        for (const BodyId body : simulation.joints.bodies(id))
            rests |= bodies.is_asleep(body.index) || !bodies.records[body.index].is_enabled;
        require(rests != simulation.joints.is_awake(id), "a joint is awake alone", id.index);
    }
}

void audit_contacts(const Simulation& simulation) {
    const std::vector<Contact>& contacts = simulation.contacts.all();
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const Contact& contact = contacts[i];
        require(contact.shapes.a < contact.shapes.b, "a contact's shapes are out of order", i);
        require(i == 0 || contacts[i - 1].shapes < contact.shapes, "contacts are out of order", i);
        require(simulation.broad.knows(contact.shapes), "a contact's pair is not known", i);
        const ShapeRecord& a = simulation.shapes[contact.shapes.a];
        const ShapeRecord& b = simulation.shapes[contact.shapes.b];
        if (!simulation.is_live(contact.shapes)) continue;  // dropped by the next step
        const bool both_sleep = simulation.bodies.is_asleep(a.body) && simulation.bodies.is_asleep(b.body);
        const bool may_wait = contact.kind != ContactKind::solid || contact.came_from == LinkSide::solid;
        require(!both_sleep || may_wait || is_over(simulation, contact), "a contact is awake alone", i);
        require(a.body == contact.body_a && b.body == contact.body_b, "a contact names a wrong body", i);
        require(contact.manifold.point_count >= 0 && contact.manifold.point_count <= 2, "manifold points", i);
        for (int point = 0; point < contact.manifold.point_count; ++point)
            require(contact.impulses[point].normal >= 0.0f, "a contact pulls", i);
    }
    const std::size_t all = contacts.size() + simulation.contacts.woken().size() + simulation.sleeping.contact_count();
    require(simulation.broad.known_count() == all, "known pairs are not the contacts", all);
}

// The graph is that of the last step: bodies that came later have no contacts in it.
void audit_blocks(const Simulation& simulation) {
    require(simulation.blocks.size() == simulation.graph.block_count(), "blocks are not the graph's", 0);
    for (std::size_t i = 0; i < simulation.blocks.size(); ++i) {
        std::vector<std::uint32_t> written;
        for (int lane = 0; lane < kLaneCount; ++lane) {
            const ContactBlock& block = simulation.blocks[i];
            if (block.inv_mass_ax[lane] + block.inv_mass_ay[lane] + block.inv_inertia_a[lane] > 0.0f)
                written.push_back(block.body_a[lane]);
            if (block.inv_mass_bx[lane] + block.inv_mass_by[lane] + block.inv_inertia_b[lane] > 0.0f)
                written.push_back(block.body_b[lane]);
        }
        std::sort(written.begin(), written.end());
        require(std::adjacent_find(written.begin(), written.end()) == written.end(), "a block shares a body", i);
    }
}

}  // namespace

void audit(const Simulation& simulation) {
    simulation.broad.audit();
    audit_bodies(simulation.bodies);
    audit_shapes(simulation);
    audit_joints(simulation);
    audit_islands(simulation);
    audit_contacts(simulation);
    audit_blocks(simulation);
}

}  // namespace tumble
