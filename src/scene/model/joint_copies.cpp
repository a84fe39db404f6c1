#include "scene/model/joint_copies.hpp"

#include "debug/check.hpp"
#include "scene/model/repeat.hpp"

namespace tumble::scene {

namespace {

// The joint for other bodies: its points and directions of the world keep their coordinates in the body.
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

struct Step {
    std::size_t copies = 0;  // by how many copies the bodies of this joint follow those of the first one
    DVec2 shift;             // of the anchor on a body without copies
};

// For each copy of the joint.
std::vector<Step> steps_of(const SceneJoint& joint) {
    const JointRepeat repeat = joint.repeat.value_or(JointRepeat{});
    std::vector<Step> steps;
    for (std::int64_t row = 0; row < repeat.rows; ++row)
        for (std::int64_t column = 0; column < repeat.columns; ++column)
            steps.push_back(
                {static_cast<std::size_t>(column + row * repeat.row_step),
                 {static_cast<double>(column) * repeat.spacing.x, static_cast<double>(row) * repeat.spacing.y}});
    return steps;
}

}  // namespace

std::size_t last_step(const SceneJoint& joint) {
    const JointRepeat repeat = joint.repeat.value_or(JointRepeat{});
    return static_cast<std::size_t>(repeat.columns - 1 + std::int64_t{repeat.rows - 1} * repeat.row_step);
}

std::vector<JointCopy> make_joints(const SceneJoint& joint, const BodyNames& names,
                                   std::span<const PlacedBody> placed) {
    const std::size_t first_a = names.find(joint.body_a).value(), first_b = names.find(joint.body_b).value();
    const bool moves_a = names.is_copy(joint.body_a), moves_b = names.is_copy(joint.body_b);
    std::vector<JointCopy> copies;
    for (const Step& step : steps_of(joint)) {
        const std::size_t a = moves_a ? first_a + step.copies : first_a, b = moves_b ? first_b + step.copies : first_b;
        TUMBLE_CHECK(a < placed.size());
        TUMBLE_CHECK(b < placed.size());
        SceneJoint copy = step.copies == 0 ? joint
                          : moves_a        ? moved(joint, placed[first_a], placed[a])
                                           : moved(joint, placed[first_b], placed[b]);
        if (copy.anchors && !moves_a) copy.anchors->first += step.shift;
        if (copy.anchors && !moves_b) copy.anchors->second += step.shift;
        copies.push_back({make_joint(copy, placed[a], placed[b]), a, b});
    }
    return copies;
}

std::vector<JointCopy> make_gears(const SceneJoint& gear, const JointNames& names) {
    const NamedCopy first_a = names.find(gear.joint_a).value(), first_b = names.find(gear.joint_b).value();
    const auto joint_at = [&](const NamedCopy& first, std::size_t step) {
        TUMBLE_CHECK(first.copy + (first.is_copy ? step : 0) < first.count);
        return names.built_index(first) + (first.is_copy ? step : 0);
    };
    std::vector<JointCopy> copies;
    for (const Step& step : steps_of(gear))
        copies.push_back({make_gear(gear), joint_at(first_a, step.copies), joint_at(first_b, step.copies)});
    return copies;
}

}  // namespace tumble::scene
