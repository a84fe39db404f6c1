#include "scene/joint_gap.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace tumble::scene {

namespace {

struct FindGap {
    const World& world;

    // From the anchor in A to that in B, world axes.
    DVec2 between_anchors(const auto& joint) const {
        return transform_point(world.state(joint.body_b).pose, joint.anchor_b) -
               transform_point(world.state(joint.body_a).pose, joint.anchor_a);
    }
    double across_axis(const auto& joint) const {
        const DVec2 axis = rotate(world.state(joint.body_a).pose.rotation, DVec2(joint.axis_a));
        return std::abs(cross(axis, between_anchors(joint))) / length(axis);
    }

    double operator()(const RevoluteJointDef& joint) const { return length(between_anchors(joint)); }
    double operator()(const WeldJointDef& joint) const { return joint.linear_spring ? 0.0 : length(between_anchors(joint)); }
    double operator()(const PrismaticJointDef& joint) const { return across_axis(joint); }
    double operator()(const WheelJointDef& joint) const { return across_axis(joint); }
    double operator()(const DistanceJointDef& joint) const {
        const double distance = length(between_anchors(joint));
        if (joint.limits)
            return std::max({0.0, double{joint.limits->lower} - distance, distance - double{joint.limits->upper}});
        return joint.spring ? 0.0 : std::abs(distance - double{joint.length});
    }
    double operator()(const MotorJointDef&) const { return 0.0; }
    double operator()(const MouseJointDef&) const { return 0.0; }
    double operator()(const FilterJointDef&) const { return 0.0; }
};

}  // namespace

double joint_gap(const World& world, const JointDef& joint) { return std::visit(FindGap{world}, joint); }

}  // namespace tumble::scene
