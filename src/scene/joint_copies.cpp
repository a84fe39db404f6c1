#include "scene/joint_copies.hpp"

namespace tumble::scene {

namespace {

// The joint as it is for other bodies: what it says of the world keeps its place in the body.
SceneJoint moved(const SceneJoint& joint, const PlacedBody& from, const PlacedBody& to) {
    SceneJoint copy = joint;
    if (joint.anchor) copy.anchor = to.pose.position + rotate(to.pose.rotation, inverse_transform_point(from.pose, *joint.anchor));
    if (joint.axis && !joint.anchors) copy.axis = rotate(to.pose.rotation, inverse_rotate(from.pose.rotation, *joint.axis));
    return copy;
}

}  // namespace

std::int64_t copy_count(const SceneJoint& joint) {
    return joint.repeat ? std::int64_t{joint.repeat->columns} * joint.repeat->rows : 1;
}

std::size_t last_step(const SceneJoint& joint) {
    const JointRepeat repeat = joint.repeat.value_or(JointRepeat{});
    return static_cast<std::size_t>(repeat.columns - 1 + std::int64_t{repeat.rows - 1} * repeat.row_step);
}

std::vector<JointDef> make_joints(const SceneJoint& joint, const BodyNames& names, std::span<const PlacedBody> placed) {
    const std::size_t a = names.find(joint.body_a).value(), b = names.find(joint.body_b).value();
    const bool moves_a = names.is_copy(joint.body_a), moves_b = names.is_copy(joint.body_b);
    const JointRepeat repeat = joint.repeat.value_or(JointRepeat{});
    std::vector<JointDef> joints;
    for (std::int64_t row = 0; row < repeat.rows; ++row) {
        for (std::int64_t column = 0; column < repeat.columns; ++column) {
            const auto step = static_cast<std::size_t>(column + row * repeat.row_step);
            const PlacedBody &own_a = placed[moves_a ? a + step : a], &own_b = placed[moves_b ? b + step : b];
            const SceneJoint copy = step == 0 ? joint : moves_a ? moved(joint, placed[a], own_a) : moved(joint, placed[b], own_b);
            joints.push_back(make_joint(copy, own_a, own_b));
        }
    }
    return joints;
}

}  // namespace tumble::scene
