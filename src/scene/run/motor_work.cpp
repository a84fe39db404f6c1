#include "scene/run/motor_work.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>

#include "scene/model/frame.hpp"

namespace tumble::scene {

namespace {

constexpr double kTurn = 2.0 * kPi;  // rad

// A motor along one free motion of a joint, in a step.
struct Drive {
    double effort = 0.0;        // N m or N, in the last sub-step
    double largest = 0.0;       // >= 0
    double displacement = 0.0;  // rad or m
    double change = 0.0;        // of the speed, rad/s or m/s
    double fastest = 0.0;       // speed, if the motion reverses within the step
};

bool has_motor(const JointDef& joint) {
    return std::visit(
        [](const auto& def) {
            using Def = std::decay_t<decltype(def)>;
            if constexpr (requires { def.motor; }) return def.motor.has_value();
            return std::is_same_v<Def, MotorJointDef>;
        },
        joint);
}

// False if the motor turns the bodies and does nothing else.
bool moves_anchors(const JointDef& joint) {
    return std::visit(
        [](const auto& def) {
            if constexpr (requires { def.motor->max_torque; }) return false;
            return true;
        },
        joint);
}

}  // namespace

MotorWork::MotorWork(const SceneWorld& built) {
    for (const SceneJointInstance& joint : built.joints)
        if (built.world.is_valid(joint.id) && has_motor(built.world.joint(joint.id))) driven_.push_back({joint.id});
}

MotorWork::Motion MotorWork::motion_of(const World& world, JointId joint) {
    const JointDef& def = world.joint(joint);
    const auto [body_a, body_b] = std::visit([](const auto& of) { return std::pair(of.body_a, of.body_b); }, def);
    const BodyState a = world.state(body_a), b = world.state(body_b);
    Motion motion{rotation_between(a.pose.rotation, b.pose.rotation),
                  double{b.angular_velocity} - double{a.angular_velocity},
                  {},
                  {}};
    if (!moves_anchors(def)) return motion;
    const JointAnchors anchors = world.joint_anchors(joint).value_or(JointAnchors{});
    motion.separation = anchors.b - anchors.a;
    motion.velocity = DVec2(world.velocity_at(body_b, anchors.b)) - DVec2(world.velocity_at(body_a, anchors.a));
    return motion;
}

void MotorWork::start_step(const World& world) {
    if (driven_.empty()) return;
    energy_ = world.energy().total();
    for (Driven& driven : driven_) start_step(world, driven);
}

void MotorWork::start_step(const World& world, Driven& driven) {
    driven.exists = world.is_valid(driven.joint);
    if (!driven.exists) return;
    const bool sleeps = !world.is_awake(driven.joint);
    if (!sleeps || !driven.was_asleep) driven.start = motion_of(world, driven.joint);
    driven.was_asleep = sleeps;
}

MotorWork::Bounds MotorWork::bounds_of(const World& world, const Driven& driven) {
    const double duration = 1.0 / world.def().steps_per_second, substep = duration / world.def().substeps;
    const Motion &start = driven.start, end = motion_of(world, driven.joint);
    const JointReaction reaction = world.reaction(driven.joint);
    const double expected = 0.5 * duration * (start.turning + end.turning);
    const double wrapped = angle(rotation_between(start.rotation, end.rotation));
    const double turned = wrapped + std::nearbyint((expected - wrapped) / kTurn) * kTurn;

    Bounds sum;
    const auto add = [&](const Drive& drive) {
        const double effort = std::clamp(drive.effort, -drive.largest, drive.largest);
        // A sub-step moves a body by its new velocity, and an impulse does work at the mean of old and new velocity.
        const double path = drive.displacement - 0.5 * substep * drive.change;
        sum.steady += effort * path;
        sum.most += drive.largest * std::max(std::abs(path), duration * drive.fastest);
    };
    const auto add_turn = [&](double largest) {
        add({double{reaction.torque}, largest, turned, end.turning - start.turning,
             std::max(std::abs(start.turning), std::abs(end.turning))});
    };
    const auto add_line = [&](DVec2 axis, double largest) {
        const double size = length(axis);
        if (size > 0.0) axis = (1.0 / size) * axis;
        add({dot(axis, DVec2(reaction.force)), largest, dot(axis, end.separation - start.separation),
             dot(axis, end.velocity - start.velocity), std::max(length(start.velocity), length(end.velocity))});
    };
    std::visit(
        [&](const auto& def) {
            using Def = std::decay_t<decltype(def)>;
            if constexpr (std::is_same_v<Def, MotorJointDef>) {
                add_turn(double{def.max_torque});
                add_line(DVec2(reaction.force), double{def.max_force});
            } else if constexpr (requires { def.motor->max_torque; }) {
                add_turn(double{def.motor->max_torque});
            } else if constexpr (requires { def.motor->max_force; }) {
                DVec2 axis = end.separation;
                if constexpr (requires { def.axis_a; })
                    axis = rotate(world.state(def.body_a).pose.rotation, DVec2(def.axis_a));
                add_line(axis, double{def.motor->max_force});
            }
        },
        world.joint(driven.joint));
    return sum;
}

double MotorWork::end_step(const World& world, double other_work) const {
    Bounds sum;
    for (const Driven& driven : driven_) {
        if (!driven.exists || !world.is_valid(driven.joint)) continue;
        if (driven.was_asleep && !world.is_awake(driven.joint)) continue;
        const Bounds bounds = bounds_of(world, driven);
        sum.steady += bounds.steady;
        sum.most += bounds.most;
    }
    if (driven_.empty()) return 0.0;
    const double grown = world.energy().total() - energy_ - other_work;
    return std::max(sum.steady, std::min(grown, sum.most));
}

}  // namespace tumble::scene
