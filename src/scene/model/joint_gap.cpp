#include "scene/model/joint_gap.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>

namespace tumble::scene {

namespace {

struct FindGap {
    const World& world;
    JointAnchors anchors;
    DVec2 between_anchors = anchors.b - anchors.a;  // world axes

    double across_axis(const auto& joint) const {
        const DVec2 axis = rotate(world.state(joint.body_a).pose.rotation, DVec2(joint.axis_a));
        return std::abs(cross(axis, between_anchors)) / length(axis);
    }

    double operator()(const RevoluteJointDef&) const { return length(between_anchors); }
    double operator()(const WeldJointDef& joint) const { return joint.linear_spring ? 0.0 : length(between_anchors); }
    double operator()(const PrismaticJointDef& joint) const { return across_axis(joint); }
    double operator()(const WheelJointDef& joint) const { return across_axis(joint); }
    double operator()(const DistanceJointDef& joint) const {
        const double distance = length(between_anchors);
        if (joint.limits)
            return std::max({0.0, double{joint.limits->lower} - distance, distance - double{joint.limits->upper}});
        return joint.spring ? 0.0 : std::abs(distance - double{joint.length});
    }
    double operator()(const PulleyJointDef& joint) const {
        const double a = length(anchors.a - joint.ground_anchor_a), b = length(anchors.b - joint.ground_anchor_b);
        return std::abs(a + double{joint.ratio} * b - double{joint.length});
    }
    double operator()(const GearJointDef&) const { return 0.0; }
    double operator()(const MotorJointDef&) const { return 0.0; }
    double operator()(const MouseJointDef&) const { return 0.0; }
    double operator()(const FilterJointDef&) const { return 0.0; }
};

}  // namespace

double joint_gap(const World& world, JointId id) {
    const std::optional<JointAnchors> anchors = world.joint_anchors(id);
    return anchors ? std::visit(FindGap{world, *anchors}, world.joint(id)) : 0.0;
}

}  // namespace tumble::scene
