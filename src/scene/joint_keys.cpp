#include "scene/joint_keys.hpp"

#include <algorithm>

#include "scene/fields.hpp"

namespace tumble::scene {

namespace {

std::string_view name_of(SceneJointType type) {
    const auto& names = kEnumNames<SceneJointType>;
    return std::find_if(names.begin(), names.end(), [&](const auto& entry) { return entry.first == type; })->second;
}

}  // namespace

bool JointKey::belongs_to(SceneJointType type) const {
    return std::find(types.begin(), types.end(), type) != types.end();
}

std::string JointKey::owners() const {
    std::string text = "belongs to ";
    for (std::size_t i = 0; i < types.size(); ++i) {
        if (i > 0) text += i + 1 < types.size() ? ", " : " and ";
        text += name_of(types[i]);
    }
    return text + " joints";
}

std::vector<JointKey> joint_keys(const SceneJoint& joint) {
    using enum SceneJointType;
    const std::vector<SceneJointType> solved = {revolute, distance, prismatic, weld, wheel, SceneJointType::motor,
                                                mouse};
    const auto key = [](std::string_view name, const auto& value, std::vector<SceneJointType> types) {
        return JointKey{name, value.has_value(), std::move(types)};
    };
    return {
        key("anchor", joint.anchor, solved),
        key("anchors", joint.anchors, solved),
        key("axis", joint.axis, {prismatic, wheel}),
        key("reference_angle", joint.reference_angle, {revolute, prismatic, weld, SceneJointType::motor}),
        key("length", joint.length, {distance}),
        key("limits", joint.limits, {revolute, distance, prismatic, wheel}),
        key("motor", joint.motor, {revolute, distance, prismatic, wheel}),
        key("spring", joint.spring, solved),
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
