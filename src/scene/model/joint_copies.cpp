#include "scene/model/joint_copies.hpp"

namespace tumble::scene {

namespace {

// The joint as it is for other bodies: what it says of the world keeps its place in the body.
SceneJoint moved(const SceneJoint& joint, const PlacedBody& from, const PlacedBody& to) {
    SceneJoint copy = joint;
    const auto move = [&](DVec2& point) {
        point = transform_point(to.pose, inverse_transform_point(from.pose, point));
    };
    if (joint.anchor) move(*copy.anchor);
    if (joint.ground_anchors) move(copy.ground_anchors->first), move(copy.ground_anchors->second);
    if (joint.axis && !joint.anchors)
        copy.axis = rotate(to.pose.rotation, inverse_rotate(from.pose.rotation, *joint.axis));
    return copy;
}

// How far the copies that each joint ties are from those of the first one.
std::vector<std::size_t> steps_of(const SceneJoint& joint) {
    const JointRepeat repeat = joint.repeat.value_or(JointRepeat{});
    std::vector<std::size_t> steps;
    for (std::int64_t row = 0; row < repeat.rows; ++row)
        for (std::int64_t column = 0; column < repeat.columns; ++column)
            steps.push_back(static_cast<std::size_t>(column + row * repeat.row_step));
    return steps;
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
    std::vector<JointDef> joints;
    for (const std::size_t step : steps_of(joint)) {
        const PlacedBody &own_a = placed[moves_a ? a + step : a], &own_b = placed[moves_b ? b + step : b];
        const SceneJoint copy = step == 0 ? joint
                                : moves_a ? moved(joint, placed[a], own_a)
                                          : moved(joint, placed[b], own_b);
        joints.push_back(make_joint(copy, own_a, own_b));
    }
    return joints;
}

std::vector<JointDef> make_gears(const SceneJoint& gear, const JointNames& names,
                                 const std::vector<std::vector<JointId>>& built) {
    const NamedPlace a = names.find(gear.joint_a).value(), b = names.find(gear.joint_b).value();
    const auto joint_at = [&](const NamedPlace& place, std::size_t step) {
        return built[place.source].at(place.is_copy ? place.copy + step : 0);
    };
    std::vector<JointDef> gears;
    for (const std::size_t step : steps_of(gear))
        gears.push_back(make_gear(gear, joint_at(a, step), joint_at(b, step)));
    return gears;
}

}  // namespace tumble::scene
