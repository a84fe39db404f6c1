#include "scene/model/joint_keys.hpp"

#include <algorithm>
#include <utility>

#include "scene/format/fields.hpp"

namespace tumble::scene {

bool JointKey::belongs_to(SceneJointType type) const {
    return std::find(types.begin(), types.end(), type) != types.end();
}

std::string JointKey::owners() const {
    std::string text = "belongs to ";
    for (std::size_t i = 0; i < types.size(); ++i) {
        if (i > 0) text += i + 1 < types.size() ? ", " : " and ";
        text += enum_name(types[i]);
    }
    return text + " joints";
}

std::vector<JointKey> joint_keys(const SceneJoint& joint) {
    using enum SceneJointType;
    const auto and_of = [](std::vector<SceneJointType> types, SceneJointType type) {
        types.push_back(type);
        return types;
    };
    const std::vector<SceneJointType> sprung = {revolute, distance, prismatic, weld, wheel, SceneJointType::motor,
                                                mouse};
    const std::vector<SceneJointType> anchored = and_of(sprung, pulley), solved = and_of(anchored, gear);
    const auto key = [](std::string_view name, const auto& value, std::vector<SceneJointType> types) {
        return JointKey{name, value.has_value(), std::move(types)};
    };
    return {
        {"bodies", !joint.body_a.empty() || !joint.body_b.empty(), and_of(anchored, filter)},
        {"joints", !joint.joint_a.empty() || !joint.joint_b.empty(), {gear}},
        key("anchor", joint.anchor, sprung),
        key("anchors", joint.anchors, anchored),
        key("ground_anchors", joint.ground_anchors, {pulley}),
        key("axis", joint.axis, {prismatic, wheel}),
        key("reference_angle", joint.reference_angle, {revolute, prismatic, weld, SceneJointType::motor}),
        key("length", joint.length, {distance, pulley}),
        key("ratio", joint.ratio, {pulley, gear}),
        key("limits", joint.limits, {revolute, distance, prismatic, wheel}),
        key("motor", joint.motor, {revolute, distance, prismatic, wheel}),
        key("spring", joint.spring, sprung),
        key("angular_spring", joint.angular_spring, {weld}),
        key("velocity", joint.velocity, {SceneJointType::motor}),
        key("angular_velocity", joint.angular_velocity, {SceneJointType::motor}),
        key("max_force", joint.max_force, {SceneJointType::motor, mouse}),
        key("max_torque", joint.max_torque, {SceneJointType::motor}),
        key("break_force", joint.break_force, solved),
        key("break_torque", joint.break_torque, solved),
    };
}

}  // namespace tumble::scene
