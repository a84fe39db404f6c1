// B slides along an axis of A and does not turn against it: two rows held, one driven.
#pragma once

#include <span>

#include "dynamics/joint_angle.hpp"
#include "dynamics/joint_block.hpp"
#include "dynamics/joint_drive.hpp"

namespace tumble {

class PrismaticJoint {
public:
    PrismaticJoint() = default;
    explicit PrismaticJoint(const PrismaticJointDef& def)
        : def_(def), drive_(def.spring, drive_motor(def.motor), def.limits) {}

    void prepare(const BodyStore& bodies);
    void warm_start(std::span<SolverBody> bodies) const;
    void solve(const JointContext& context, bool use_bias, std::span<SolverBody> bodies);
    JointReaction reaction(float inv_h) const {
        return {inv_h * (drive_.impulse() * axis_ + impulse_.x * perp(axis_)), inv_h * impulse_.y};
    }
    float position() const { return dot(axis_, bodies_.center_difference + bodies_.arm_b - bodies_.arm_a); }
    void take_over(const PrismaticJoint& old);

    template <class Self, class Visitor>
    static void visit_members(Self& self, Visitor&& visit) {
        visit(self.def_, self.bodies_, self.angle_, self.drive_, self.axis_, self.impulse_);
    }

private:
    // The geometry within the step.
    struct Rail {
        Vec2 axis;  // turned with A
        Vec2 separation;
        JointRow along;
        RowBlock held;  // across the axis, and turning
    };
    Rail rail(std::span<const SolverBody> bodies) const;

    PrismaticJointDef def_;
    JointBodies bodies_;
    JointAngle angle_;
    JointDrive drive_;
    Vec2 axis_;     // world, unit, at the start of the step
    Vec2 impulse_;  // across the axis (N s) and turning (N m s)
};

}  // namespace tumble
