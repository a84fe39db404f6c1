#include "scene/build/validate_joint_keys.hpp"

#include "scene/model/joint_keys.hpp"

namespace tumble::scene {

void validate_joint_keys(const SceneJoint& joint, const std::string& pointer, Diagnostics& diagnostics) {
    const bool is_distance = joint.type == SceneJointType::distance, is_pulley = joint.type == SceneJointType::pulley;
    const auto refuse = [&](bool present, const std::string& key, const std::string& reason,
                            const std::string& hint = "") {
        if (present) diagnostics.error(pointer + '/' + key, reason, hint);
    };
    const bool is_gear = joint.type == SceneJointType::gear;
    refuse(is_distance && joint.anchor.has_value(), "anchor", "a distance joint needs 'anchors', one in each body");
    for (const JointKey& key : joint_keys(joint))
        refuse(key.is_present && !key.belongs_to(joint.type), std::string(key.name), key.owners(),
               is_gear && key.name == "bodies" ? R"("joints": ["a", "b"] names the two joints that mesh)" : "");
    refuse(is_distance && joint.limits && joint.limits->lower < 0.0, "limits",
           "the limits of a distance must not be negative");
    refuse(is_pulley && joint.ratio && !(*joint.ratio > 0.0), "ratio", "must be greater than 0");
    refuse(!is_pulley && joint.ratio && *joint.ratio == 0.0, "ratio", "must not be 0");
    if (is_pulley && !joint.ground_anchors)
        diagnostics.error(pointer, "the key 'ground_anchors' is missing: the wheels that the rope runs over");
    if (is_pulley && !joint.anchors)
        diagnostics.error(pointer, "the key 'anchors' is missing: the ends of the rope, one in each body");
    if (joint.type == SceneJointType::filter || is_gear || is_pulley) return;
    if (joint.anchor.has_value() == joint.anchors.has_value())
        diagnostics.error(pointer, "needs one of the keys anchor, anchors");
    const bool has_axis = joint.type == SceneJointType::prismatic || joint.type == SceneJointType::wheel;
    if (has_axis && !joint.axis)
        diagnostics.error(pointer, "the key 'axis' is missing: the direction of the free motion");
    if (!joint.motor) return;
    const bool slides = is_distance || joint.type == SceneJointType::prismatic;
    refuse(slides && !joint.motor->max_force, "motor", "the motor of a joint that slides needs 'max_force', in N");
    refuse(!slides && !joint.motor->max_torque, "motor", "the motor of a joint that turns needs 'max_torque', in N m");
}

}  // namespace tumble::scene
