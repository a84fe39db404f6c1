// B slides along an axis of A and does not turn against it: two rows held, one driven.
#pragma once

#include <span>

#include "dynamics/rows/joint_angle.hpp"
#include "dynamics/rows/joint_block.hpp"
#include "dynamics/rows/joint_drive.hpp"

namespace tumble {

class PrismaticJoint {
public:
    PrismaticJoint() = default;
    explicit PrismaticJoint(const PrismaticJointDef& def)
        : def_(def), drive_(def.spring, drive_motor(def.motor), def.limits) {}

    void prepare(const BodyStore& bodies);
    void warm_start(std::span<SolverBody> bodies) const;
    void solve(const JointContext& context, bool use_bias, std::span<SolverBody> bodies);
    JointReaction reaction(float inv_h) const;
    float position() const { return dot(axis_, bodies_.separation_at_start()); }
    void take_over(const PrismaticJoint& old);
    void forget_impulses() { impulse_ = {}, drive_.forget_impulses(); }

    template <class Self, class Visitor>
    static void visit_members(Self& self, Visitor&& visit) {
        visit(self.def_, self.bodies_, self.angle_, self.drive_, self.axis_, self.impulse_, self.answer_);
    }

private:
    // The geometry within the step. What drives the slider and what holds it would undo each other's work on a long
    // rail, and slowly agree, or never: a light slider that its limits pull two ways was thrown about at 400 m/s.
    struct Rail {
        Vec2 axis;  // turned with A
        Vec2 separation;
        RowBlock held;  // across the axis, and turning
        Vec2 answer;    // of the held rows to a unit impulse along the axis
        JointRow free;  // along the axis, with that answer: moves the slider and asks nothing of what holds it
    };
    Rail rail(std::span<const SolverBody> bodies) const;

    PrismaticJointDef def_;
    JointBodies bodies_;
    JointAngle angle_;
    JointDrive drive_;
    Vec2 axis_;     // world, unit, at the start of the step
    Vec2 impulse_;  // of the held rows: across the axis (N s) and turning (N m s), but for their answer to the drive
    Vec2 answer_;   // in the last solve
};

}  // namespace tumble
