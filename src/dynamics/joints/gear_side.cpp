#include "dynamics/joints/gear_side.hpp"

#include <cmath>

#include "dynamics/rows/joint_ends.hpp"

namespace tumble {

namespace {

// Of the angles that differ from one by whole turns, the nearest to another.
double nearest_turn(double angle, double other) { return other + std::remainder(angle - other, 2.0 * kPi); }

}  // namespace

GearSide::GearSide(const JointDef& joint) {
    body_a_ = joint_body_a(joint).index;
    body_b_ = joint_body_b(joint).index;
    const auto* slider = std::get_if<PrismaticJointDef>(&joint);
    slides_ = slider != nullptr;
    if (!slides_) return;
    anchor_a_ = slider->anchor_a;
    anchor_b_ = slider->anchor_b;
    axis_a_ = unit(slider->axis_a);
}

double GearSide::advance(const BodyStore& bodies, JointBodies& joint) {
    const BodyFrame& a = bodies.frames[body_a_];
    const BodyFrame& b = bodies.frames[body_b_];
    joint = JointBodies::make(a, anchor_a_, b, anchor_b_);
    axis_ = rotate(a.pose.rotation, axis_a_);
    const double before = motion_;
    motion_ = slides_ ? static_cast<double>(dot(axis_, joint.separation_at_start()))
                      : relative_angle(a.pose.rotation, b.pose.rotation);
    const double change = is_known_ ? motion_ - before : 0.0;
    const double advanced = slides_ ? change : nearest_turn(change, moved_);
    moved_ = 0.0;
    is_known_ = true;
    return advanced;
}

JointRow GearSide::row(const JointBodies& joint, std::span<const SolverBody> all) const {
    if (!slides_) return kTurningRow;
    return sliding_row(axis_now(joint, all), joint.current_arm_a(all), joint.current_separation(all),
                       joint.current_arm_b(all));
}

float GearSide::follow(const JointBodies& joint, std::span<const SolverBody> all) {
    if (slides_)
        moved_ = static_cast<double>(dot(axis_now(joint, all), joint.current_separation(all))) - motion_;
    else
        moved_ = nearest_turn(relative_angle(all[joint.a].delta_rotation, all[joint.b].delta_rotation), moved_);
    return static_cast<float>(moved_);
}

bool GearSide::measures_as(const GearSide& other) const {
    return anchor_a_ == other.anchor_a_ && anchor_b_ == other.anchor_b_ && axis_a_ == other.axis_a_;
}

}  // namespace tumble
