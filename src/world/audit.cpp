#include "world/audit.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "dynamics/bodies/divergence.hpp"
#include "dynamics/contacts/recycling.hpp"
#include "dynamics/joints/gear_side.hpp"
#include "dynamics/rows/joint_ends.hpp"
#include "dynamics/state/collision_rules.hpp"

namespace tumble {

namespace {

void ensure(bool holds, const char* invariant, std::size_t index) {
    if (!holds) throw std::logic_error("world: " + std::string(invariant) + " (index " + std::to_string(index) + ")");
}

void audit_bodies(const BodyStore& bodies) {
    ensure(bodies.moving.size() == bodies.solver_bodies.size(), "solver bodies and moving bodies differ in number",
           bodies.moving.size());
    ensure(bodies.solver_bodies[kStaticSolverBody].velocity == Vec2{}, "the static solver body moves", 0);
    std::size_t moving = 1;
    for (const BodyId id : bodies.ids.live()) {
        const BodyFrame& frame = bodies.frames[id.index];
        const bool is_asleep = bodies.records[id.index].island != kNoIsland;
        const bool is_static = frame.type == BodyType::static_body || is_asleep;  // for the solver
        ensure(!is_asleep || bodies.is_dynamic(id.index), "a body sleeps that is not dynamic", id.index);
        ensure(is_static == (frame.solver_body == kStaticSolverBody),
               "a static or sleeping body has a solver body, or another has none", id.index);
        ensure((frame.inv_mass > 0.0f) == bodies.is_dynamic(id.index),
               "a body that is not dynamic has a mass, or a dynamic one has none", id.index);
        ensure(bodies.records[id.index].is_enabled || is_static, "a disabled body has a solver body", id.index);
        if (is_static) continue;
        ++moving;
        ensure(frame.solver_body < bodies.moving.size(), "a solver body is out of range", id.index);
        ensure(bodies.moving[frame.solver_body].body == id.index, "a solver body belongs to another body", id.index);
    }
    ensure(moving == bodies.moving.size(), "a solver body belongs to no moving body", moving);
}

void audit_ids(const Simulation& simulation) {
    ensure(simulation.bodies.ids.is_sound(), "the list of bodies differs from the owners of their indices", 0);
    ensure(simulation.shapes.ids.is_sound(), "the list of shapes differs from the owners of their indices", 0);
    ensure(simulation.joints.ids.is_sound(), "the list of joints differs from the owners of their indices", 0);
}

// What the motion of a body says of its shapes, also in the copy that steps read.
void audit_motion(const Simulation& simulation, std::uint32_t body) {
    const BodyRecord& record = simulation.bodies.records[body];
    const bool has_one = record.shapes.size() == 1;
    ensure(record.motion.only_shape == (has_one ? record.shapes[0].index : kNoShape),
           "the only shape of a body is not in its list", body);
    ensure(record.motion.mass_center == record.mass.center, "the motion of a body has another centre of mass", body);
    const std::uint32_t solver_body = simulation.bodies.frames[body].solver_body;
    if (solver_body == kStaticSolverBody) return;
    ensure(simulation.bodies.moving[solver_body].motion.mass_center == record.motion.mass_center,
           "a moving body has another centre of mass", body);
    ensure(simulation.bodies.moving[solver_body].motion.only_shape == record.motion.only_shape,
           "a moving body has another only shape", body);
}

void audit_shapes(const Simulation& simulation) {
    std::size_t owned = 0;
    for (const BodyId body : simulation.bodies.ids.live()) {
        audit_motion(simulation, body.index);
        for (const ShapeId id : simulation.bodies.records[body.index].shapes) {
            ++owned;
            ensure(simulation.shapes.ids.is_live(id), "a body lists a destroyed shape", body.index);
            ensure(simulation.shapes[id.index].body == body.index, "a shape belongs to another body", id.index);
            const bool is_placed = simulation.shapes[id.index].is_placed;
            const bool is_enabled = simulation.bodies.records[body.index].is_enabled;
            ensure(is_placed ? is_enabled : !is_enabled || !has_finite_pose(simulation.bodies, body.index),
                   "a shape of a disabled body has a proxy, or one of an enabled body has none", id.index);
            if (!simulation.shapes[id.index].is_placed) continue;
            const Aabb box = bounds(simulation.shapes[id.index].shape, simulation.bodies.frames[body.index].pose);
            ensure(contains(simulation.broad.box(id.index), box), "a proxy's box does not contain its shape", id.index);
        }
    }
    ensure(owned == simulation.shapes.ids.live().size(), "a shape is on no body", owned);
}

void audit_gear(const JointStore& joints, JointId id, const GearJointDef& gear) {
    ensure(gear.joint_a != gear.joint_b, "a gear joins a joint to itself", id.index);
    for (const JointId joint : {gear.joint_a, gear.joint_b}) {
        ensure(joints.ids.is_live(joint), "a gear is on a destroyed joint", id.index);
        ensure(can_be_geared(joints.def(joint)), "a gear is on a joint that cannot be geared", id.index);
    }
    ensure(
        gear.body_a == joint_body_b(joints.def(gear.joint_a)) && gear.body_b == joint_body_b(joints.def(gear.joint_b)),
        "a gear's bodies are not the second bodies of its joints", id.index);
}

void audit_joints(const Simulation& simulation) {
    ensure(simulation.joints.has_all_loads(), "the joints and their loads differ in number", 0);
    std::size_t ends = 0;
    for (const JointId id : simulation.joints.ids.live()) {
        if (const auto* gear = std::get_if<GearJointDef>(&simulation.joints.def(id)))
            audit_gear(simulation.joints, id, *gear);
        for (const BodyId body : simulation.joints.bodies(id)) {
            ++ends;
            ensure(simulation.bodies.ids.is_live(body), "a joint is on a destroyed body", id.index);
            const std::vector<JointId>& joints = simulation.bodies.records[body.index].joints;
            ensure(std::count(joints.begin(), joints.end(), id) == 1, "a body does not list its joint exactly once",
                   id.index);
        }
    }
    std::size_t listed = 0;
    for (const BodyId body : simulation.bodies.ids.live())
        listed += simulation.bodies.records[body.index].joints.size();
    ensure(listed == ends, "a body lists a destroyed joint", listed);
}

// What a valid reference has from its shapes and its contact. The shapes must be live.
void audit_reference(const Simulation& simulation, const Contact& contact, std::size_t i) {
    const ManifoldReference& reference = contact.reference;
    ensure(reference.manifold.point_count >= 0 && reference.manifold.point_count <= 2,
           "the manifold of a reference has fewer than 0 or more than 2 points", i);
    if (reference.tolerance < 0.0f) return;
    const ShapeRecord& a = simulation.shapes[contact.shapes.a];
    const ShapeRecord& b = simulation.shapes[contact.shapes.b];
    ensure(reference.reach_a == a.reach && reference.reach_b == b.reach,
           "the reaches of a reference are not those of its shapes", i);
    const bool may_be_sharp = reference.manifold.point_count > 0 && contact.radius_a == 0.0f &&
                              contact.radius_b == 0.0f && !a.link && !b.link;
    ensure(reference.corners == -1.0f || (may_be_sharp && reference.corners >= 0.0f && reference.corners < 8.0f),
           "a reference names sharp corners that its shapes do not have", i);
    ensure(reference.tolerance == recycling_tolerance(contact, smaller_extent(a, b)),
           "the tolerance of a reference is not that of its contact", i);
}

void audit_islands(const Simulation& simulation) {
    const BodyStore& bodies = simulation.bodies;
    std::size_t listed = 0, count = 0, asleep_count = 0;
    for (std::size_t i = 0; i < simulation.sleeping.all().size(); ++i) {
        const SleepingIsland& island = simulation.sleeping.all()[i];
        listed += island.bodies.size();
        count += !island.bodies.empty();
        ensure(std::is_sorted(island.bodies.begin(), island.bodies.end()), "an island's bodies are not sorted", i);
        for (const std::uint32_t body : island.bodies)
            ensure(bodies.records[body].island == i, "a body of an island names another island", body);
        for (const Contact& contact : island.contacts) {
            ensure(contact.manifold.point_count > 0, "a sleeping contact has no points", i);
            ensure(contact.manifold.point_count <= 2, "a sleeping contact has more than 2 points", i);
            ensure(bodies.records[contact.body_a].island == i || bodies.records[contact.body_b].island == i,
                   "a sleeping contact has no body in its island", i);
            ensure(simulation.broad.has_pair(contact.shapes),
                   "the pair of a sleeping contact is not in the broad phase", i);
            if (simulation.is_live(contact.shapes)) audit_reference(simulation, contact, i);
        }
    }
    ensure(count == simulation.sleeping.count(), "an island in use is empty", count);
    for (const BodyId id : bodies.ids.live()) asleep_count += bodies.is_asleep(id.index);
    ensure(listed == asleep_count, "a sleeping body is in no island", asleep_count);
    for (const JointId id : simulation.joints.ids.live()) {
        bool must_sleep = false;
        for (const BodyId body : simulation.joints.bodies(id))
            must_sleep |= bodies.is_asleep(body.index) || !bodies.records[body.index].is_enabled;
        ensure(must_sleep != simulation.joints.is_awake(id),
               "a joint is awake beside a sleeping or disabled body, or asleep beside none", id.index);
    }
}

void audit_contacts(const Simulation& simulation) {
    const std::vector<Contact>& contacts = simulation.contacts.all();
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const Contact& contact = contacts[i];
        ensure(contact.shapes.a < contact.shapes.b, "a contact's shapes are not sorted", i);
        ensure(i == 0 || contacts[i - 1].shapes < contact.shapes, "contacts are not sorted", i);
        ensure(simulation.broad.has_pair(contact.shapes), "the pair of a contact is not in the broad phase", i);
        const ShapeRecord& a = simulation.shapes[contact.shapes.a];
        const ShapeRecord& b = simulation.shapes[contact.shapes.b];
        if (!simulation.is_live(contact.shapes)) continue;  // the next step drops it
        const bool both_sleep = simulation.bodies.is_asleep(a.body) && simulation.bodies.is_asleep(b.body);
        const bool may_wait = contact.kind != ContactKind::solid || contact.chain_state == ChainState::crossing;
        ensure(!both_sleep || may_wait || is_over(simulation, contact), "a contact is awake between sleeping bodies",
               i);
        ensure(a.body == contact.body_a && b.body == contact.body_b, "a contact's bodies are not those of its shapes",
               i);
        ensure(contact.manifold.point_count >= 0 && contact.manifold.point_count <= 2,
               "a manifold has fewer than 0 or more than 2 points", i);
        for (int point = 0; point < contact.manifold.point_count; ++point)
            ensure(contact.impulses[point].normal >= 0.0f, "a contact has a negative normal impulse", i);
        audit_reference(simulation, contact, i);
    }
    const std::size_t all = contacts.size() + simulation.contacts.woken().size() + simulation.sleeping.contact_count();
    ensure(simulation.broad.pair_count() == all, "the pairs of the broad phase and the contacts differ in number", all);
}

}  // namespace

void audit(const Simulation& simulation) {
    simulation.broad.audit();
    audit_bodies(simulation.bodies);
    audit_ids(simulation);
    audit_shapes(simulation);
    audit_joints(simulation);
    audit_islands(simulation);
    ensure(simulation.steps_to_island_search <= kPauseAfterSearch, "the search for islands at rest pauses too long",
           simulation.steps_to_island_search);
    audit_contacts(simulation);
    if (const StepScratch* scratch = simulation.scratch.own()) scratch->contact_solver.audit();
}

}  // namespace tumble
