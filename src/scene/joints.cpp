// Anchors given in the world become local ones of both bodies; what is left out is taken from the poses at load.
#include "scene/joints.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace tumble::scene {

namespace {

std::pair<Vec2, Vec2> local_anchors(const SceneJoint& joint, const Pose& a, const Pose& b) {
    if (joint.anchors) return {to_float(joint.anchors->first), to_float(joint.anchors->second)};
    const DVec2 world = joint.anchor.value_or(DVec2{});
    return {to_float(inverse_transform_point(a, world)), to_float(inverse_transform_point(b, world))};
}

}  // namespace

JointDef make_joint(const SceneJoint& joint, const PlacedBody& a, const PlacedBody& b) {
    const auto [anchor_a, anchor_b] = local_anchors(joint, a.pose, b.pose);
    if (joint.type == SceneJointType::revolute) {
        // The joint angle is known up to whole turns only: the reference is the nearest to 0 of its kind.
        const double degrees = std::remainder(joint.reference_angle.value_or(b.angle - a.angle), 360.0);
        return RevoluteJointDef{.body_a = a.id,
                                .body_b = b.id,
                                .anchor_a = anchor_a,
                                .anchor_b = anchor_b,
                                .reference_angle = static_cast<float>(degrees * (kPi / 180.0)),
                                .collide_connected = joint.collide_connected};
    }
    const double at_load = length(transform_point(b.pose, anchor_b) - transform_point(a.pose, anchor_a));
    const float joint_length = static_cast<float>(joint.length.value_or(at_load));
    if (!(joint_length > 0.0f)) throw std::invalid_argument("a distance joint needs anchors that are apart");
    return DistanceJointDef{.body_a = a.id,
                            .body_b = b.id,
                            .anchor_a = anchor_a,
                            .anchor_b = anchor_b,
                            .length = joint_length,
                            .collide_connected = joint.collide_connected};
}

}  // namespace tumble::scene
