// Joints: creating, changing and destroying them, and what they report.
#include <optional>
#include <stdexcept>
#include <string>

#include "dynamics/joints/gear_side.hpp"
#include "dynamics/rows/joint_ends.hpp"
#include "dynamics/stages/sleep.hpp"
#include "world/input_checks.hpp"
#include "world/world_impl.hpp"

namespace tumble {

namespace {

bool have_same_joints(const JointDef& a, const JointDef& b) {
    const auto *gear = std::get_if<GearJointDef>(&a), *other = std::get_if<GearJointDef>(&b);
    return !gear || !other || (gear->joint_a == other->joint_a && gear->joint_b == other->joint_b);
}

// A new joint between sleeping bodies sleeps with them, and joins their islands; a joint with an active body wakes all
// of its bodies. A joint of a disabled body sleeps.
void settle_sleep(Simulation& simulation, JointId id) {
    const BodyStore& bodies = simulation.bodies;
    bool all_enabled = true, any_active = false;
    std::optional<std::uint32_t> sleeper;
    for (const BodyId body : simulation.joints.bodies(id)) {
        all_enabled &= bodies.records[body.index].is_enabled;
        any_active |= bodies.is_active(body.index);
        if (!sleeper && bodies.is_asleep(body.index)) sleeper = body.index;
    }
    if (all_enabled && any_active) {
        for (const BodyId body : simulation.joints.bodies(id)) wake(simulation, body.index);
    } else if (all_enabled && sleeper) {
        for (const BodyId body : simulation.joints.bodies(id))
            if (bodies.is_asleep(body.index)) merge_sleeping_islands(simulation, *sleeper, body.index);
    }
    if (!all_enabled || (!any_active && sleeper)) simulation.joints.put_to_sleep({&id, 1});
}

[[noreturn]] void refuse(JointId id, const char* what) {
    throw std::invalid_argument("joint " + std::to_string(id.index) + " has no " + what);
}

}  // namespace

template <class Change>
void World::Impl::change_joint(JointId id, Change&& change) {
    require(id);
    JointDef joint = simulation.joints.def(id);
    std::visit(change, joint);
    check(joint);
    for (const BodyId body : simulation.joints.bodies(id)) wake(simulation, body.index);
    simulation.joints.redefine(id, joint);
}

JointDef World::Impl::with_gear_bodies(const JointDef& joint) const {
    if (!std::holds_alternative<GearJointDef>(joint)) return joint;
    GearJointDef gear = std::get<GearJointDef>(joint);
    for (const JointId geared : {gear.joint_a, gear.joint_b}) {
        require(geared);
        if (!can_be_geared(simulation.joints.def(geared)))
            throw std::invalid_argument("gear needs revolute or prismatic joints: joint " +
                                        std::to_string(geared.index) + " is neither");
    }
    if (gear.joint_a == gear.joint_b)
        throw std::invalid_argument("gear needs two joints, got joint " + std::to_string(gear.joint_a.index) +
                                    " twice");
    gear.body_a = joint_body_b(simulation.joints.def(gear.joint_a));
    gear.body_b = joint_body_b(simulation.joints.def(gear.joint_b));
    return gear;
}

bool World::is_valid(JointId id) const noexcept { return impl_->simulation.joints.ids.is_live(id); }

std::span<const JointId> World::joints() const noexcept { return impl_->simulation.joints.ids.live(); }

std::span<const JointId> World::joints(BodyId id) const {
    impl_->require(id);
    return impl_->simulation.bodies.records[id.index].joints;
}

JointId World::create_joint(const JointDef& def) {
    const JointDef joint = impl_->with_gear_bodies(def);
    const BodyId a = joint_body_a(joint), b = joint_body_b(joint);
    impl_->require(a);
    impl_->require(b);
    if (a == b && !std::holds_alternative<GearJointDef>(joint))
        throw std::invalid_argument("joint needs two bodies, got body " + std::to_string(a.index) + " twice");
    check(joint);
    Simulation& simulation = impl_->simulation;
    const JointId id = simulation.joints.create(joint);
    for (const BodyId body : simulation.joints.bodies(id)) simulation.bodies.records[body.index].joints.push_back(id);
    simulation.filters_changed |= !collides_connected(joint);
    // If the two bodies sleep and touch, that contact ends now: one may have rested on the other.
    if (!collides_connected(joint) && touch_in_sleep(simulation, a.index, b.index))
        for (const BodyId body : {a, b}) wake(simulation, body.index);
    settle_sleep(simulation, id);
    return id;
}

void World::set_joint(JointId id, const JointDef& def) {
    impl_->require(id);
    Simulation& simulation = impl_->simulation;
    const JointDef& old = simulation.joints.def(id);
    const JointDef joint = impl_->with_gear_bodies(def);
    if (joint.index() != old.index() || joint_body_a(joint) != joint_body_a(old) ||
        joint_body_b(joint) != joint_body_b(old) || !have_same_joints(joint, old))
        throw std::invalid_argument("joint " + std::to_string(id.index) +
                                    " must keep its kind, its bodies and its joints");
    check(joint);
    for (const BodyId body : simulation.joints.bodies(id)) {
        wake(simulation, body.index);
        impl_->touch_proxies(body);
    }
    simulation.filters_changed |= !collides_connected(joint);
    simulation.joints.redefine(id, joint);
    for (const JointId gear : impl_->gears_on(id))
        simulation.joints.redefine(gear, JointDef(simulation.joints.def(gear)));
}

void World::set_motor_speed(JointId id, float speed) {
    impl_->change_joint(id, [&](auto& def) {
        if constexpr (requires { def.motor; }) {
            if (!def.motor) refuse(id, "motor");
            def.motor->speed = speed;
        } else {
            refuse(id, "motor");
        }
    });
}

void World::set_motor(JointId id, float speed, float max_effort) {
    impl_->change_joint(id, [&](auto& def) {
        if constexpr (requires { def.motor; })
            def.motor = {speed, max_effort};
        else
            refuse(id, "motor");
    });
}

void World::set_limits(JointId id, const std::optional<JointLimits>& limits) {
    impl_->change_joint(id, [&](auto& def) {
        if constexpr (requires { def.limits; })
            def.limits = limits;
        else
            refuse(id, "limits");
    });
}

void World::set_spring(JointId id, const std::optional<JointSpring>& spring) {
    impl_->change_joint(id, [&](auto& def) {
        if constexpr (requires { def.spring.reset(); })
            def.spring = spring;
        else if constexpr (requires { def.spring; })
            spring ? void(def.spring = *spring) : refuse(id, "other force than its spring, which cannot be removed");
        else
            refuse(id, "spring");
    });
}

void World::set_target(JointId id, DVec2 target) {
    check_point(target);
    impl_->change_joint(id, [&](auto& def) {
        if constexpr (std::is_same_v<std::decay_t<decltype(def)>, MouseJointDef>)
            def.anchor_a = to_float(inverse_transform_point(state(def.body_a).pose, target));
        else
            refuse(id, "target");
    });
}

void World::destroy_joint(JointId id) {
    impl_->require(id);
    impl_->destroy_joint(id);
}

bool World::is_awake(JointId id) const {
    impl_->require(id);
    return impl_->simulation.joints.is_awake(id);
}

const JointDef& World::joint(JointId id) const {
    impl_->require(id);
    return impl_->simulation.joints.def(id);
}

JointReaction World::reaction(JointId id) const {
    impl_->require(id);
    return impl_->simulation.joints.reaction(id);
}

std::optional<JointAnchors> World::joint_anchors(JointId id) const {
    impl_->require(id);
    const auto world_point = [this](BodyId body, Vec2 anchor) {
        return transform_point(impl_->simulation.bodies.frames[body.index].pose, anchor);
    };
    const auto find = [&](const auto& def) -> std::optional<JointAnchors> {
        if constexpr (requires { def.anchor_a; })
            return JointAnchors{world_point(def.body_a, def.anchor_a), world_point(def.body_b, def.anchor_b)};
        else if constexpr (requires { def.joint_a; })
            return JointAnchors{joint_anchors(def.joint_a)->b, joint_anchors(def.joint_b)->b};
        else
            return std::nullopt;
    };
    return std::visit(find, impl_->simulation.joints.def(id));
}

float World::joint_position(JointId id) const {
    impl_->require(id);
    return impl_->simulation.joints.position(id);
}

std::uint64_t World::user_data(JointId id) const {
    impl_->require(id);
    return std::visit([](const auto& def) { return def.user_data; }, impl_->simulation.joints.def(id));
}

void World::set_user_data(JointId id, std::uint64_t data) {
    impl_->require(id);
    impl_->simulation.joints.set_user_data(id, data);
}

}  // namespace tumble
