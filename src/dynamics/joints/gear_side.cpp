#include "dynamics/joints/gear_side.hpp"

#include <cmath>

#include "debug/check.hpp"
#include "dynamics/rows/joint_ends.hpp"

namespace tumble {

namespace {

// `angle` plus the whole turns that bring it nearest to `other`.
double nearest_turn(double angle, double other) { return other + std::remainder(angle - other, 2.0 * kPi); }

}  // namespace

GearSide::GearSide(const JointDef& joint) {
    body_a_ = joint_body_a(joint).index;
    body_b_ = joint_body_b(joint).index;
    const auto* slider = std::get_if<PrismaticJointDef>(&joint);
    TUMBLE_CHECK(can_be_geared(joint));
    slides_ = slider != nullptr;
    if (!slides_) return;
    anchor_a_ = slider->anchor_a;
    anchor_b_ = slider->anchor_b;
    axis_a_ = unit(slider->axis_a);
}

double GearSide::start_step(const BodyStore& bodies, JointBodies& joint) {
    TUMBLE_CHECK(body_a_ < bodies.frames.size());
    TUMBLE_CHECK(body_b_ < bodies.frames.size());
    const BodyFrame& a = bodies.frames[body_a_];
    const BodyFrame& b = bodies.frames[body_b_];
    joint = JointBodies::make(a, anchor_a_, b, anchor_b_);
    axis_ = rotate(a.pose.rotation, axis_a_);
    const double before = motion_;
    motion_ = slides_ ? static_cast<double>(dot(axis_, joint.separation_at_start()))
                      : relative_angle(a.pose.rotation, b.pose.rotation);
    const double change = is_measured_ ? motion_ - before : 0.0;
    const double advanced = slides_ ? change : nearest_turn(change, change_);
    change_ = 0.0;
    is_measured_ = true;
    return advanced;
}

JointRow GearSide::row(const JointBodies& joint, std::span<const SolverBody> all) const {
    if (!slides_) return kAngularRow;
    const Vec2 arm_a = joint.current_arm_a(all), arm_b = joint.current_arm_b(all);
    return sliding_row(axis_now(joint, all), arm_a, joint.separation_of(arm_a, arm_b, all), arm_b);
}

float GearSide::change_in_step(const JointBodies& joint, std::span<const SolverBody> all) {
    if (slides_)
        change_ = static_cast<double>(dot(axis_now(joint, all), joint.current_separation(all))) - motion_;
    else
        change_ = nearest_turn(relative_angle(all[joint.a].delta_rotation, all[joint.b].delta_rotation), change_);
    return static_cast<float>(change_);
}

bool GearSide::measures_same_as(const GearSide& other) const {
    return anchor_a_ == other.anchor_a_ && anchor_b_ == other.anchor_b_ && axis_a_ == other.axis_a_;
}

}  // namespace tumble
