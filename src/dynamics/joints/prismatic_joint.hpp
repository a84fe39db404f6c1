// Prismatic joint (slider): B moves along an axis of A and does not rotate against it. Two rows are constrained and
// solved as a block: across the axis (m, N s) and the angle against the reference angle (rad, N m s). The third, along
// the axis, is free for a drive: spring, motor and limits of the displacement of B's anchor from A's (m, N s on B).
#pragma once

#include <span>

#include "dynamics/rows/equality_row.hpp"
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
    void update_rows(std::span<const SolverBody> bodies);
    void warm_start(std::span<SolverBody> bodies) const;
    void solve(const JointContext& context, bool use_bias, std::span<SolverBody> bodies);

    // Calls visit(EqualityRow) for each equality constraint, at the present deltas of the bodies.
    template <class Visitor>
    void visit_equalities(std::span<const SolverBody> bodies, Visitor&& visit) {
        const Rail now = rail(bodies);
        visit_block(bodies_, now.constrained, constrained_error(now, bodies), impulse_, visit);
    }
    JointReaction reaction(float inv_h) const;
    float position() const { return dot(axis_, bodies_.separation_at_start()); }
    void take_over(const PrismaticJoint& old);
    void forget_impulses() { impulse_ = {}, drive_.forget_impulses(); }

    template <class Self, class Visitor>
    static void visit_members(Self& self, Visitor&& visit) {
        visit(self.def_, self.bodies_, self.angle_, self.drive_, self.axis_, self.rail_, self.impulse_);
    }

private:
    // The geometry and the rows within the step. An impulse along the axis also changes the velocities of the
    // constrained rows, the more the longer the rail. Solved one after the other, drive and block would converge slowly
    // or not at all (a light slider between two limits reached 400 m/s), so the drive acts along a row without that
    // effect.
    struct Rail {
        Vec2 axis;             // world, unit, rotated with A
        Vec2 separation;       // from A's anchor to B's, m
        RowBlock constrained;  // across the axis, and the angle
        Vec2 compensation;     // impulses of the constrained rows against a unit impulse along the axis
        JointRow free;         // along the axis, with that compensation
    };
    Rail rail(std::span<const SolverBody> bodies) const;
    Vec2 constrained_error(const Rail& now, std::span<const SolverBody> bodies) const;

    PrismaticJointDef def_;
    JointBodies bodies_;
    JointAngle angle_;
    JointDrive drive_;
    Vec2 axis_;     // world, unit, at the start of the step
    Rail rail_;     // of the last update_rows()
    Vec2 impulse_;  // of the constrained rows, without their compensation: across the axis (N s), angular (N m s)
};

}  // namespace tumble
