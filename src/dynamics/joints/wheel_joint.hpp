// Wheel joint: a wheel B on a suspension of chassis A. Three rows: across the axis of A an equality constraint (m, N
// s); along it a drive, the suspension, with spring and limits of the displacement of B's anchor from A's (m, N s); and
// the angular row with the motor (rad/s, N m s, counter-clockwise positive for B).
#pragma once

#include <span>

#include "dynamics/rows/equality_row.hpp"
#include "dynamics/rows/joint_drive.hpp"

namespace tumble {

class WheelJoint {
public:
    WheelJoint() = default;
    explicit WheelJoint(const WheelJointDef& def)
        : def_(def),
          suspension_(def.spring, std::nullopt, def.limits),
          axle_(std::nullopt, drive_motor(def.motor), std::nullopt) {}

    void prepare(const BodyStore& bodies);
    void update_rows(std::span<const SolverBody> bodies);
    void warm_start(std::span<SolverBody> bodies) const;
    void solve(const JointContext& context, bool use_bias, std::span<SolverBody> bodies);

    // Calls visit(EqualityRow) for each equality constraint, at the present deltas of the bodies.
    template <class Visitor>
    void visit_equalities(std::span<const SolverBody> bodies, Visitor&& visit) {
        const Strut now = strut(bodies);
        visit(make_equality(bodies_, now.across, dot(perp(now.axis), now.separation), across_impulse_));
    }
    JointReaction reaction(float inv_h) const {
        return {inv_h * (suspension_.impulse() * axis_ + across_impulse_ * perp(axis_)), inv_h * axle_.impulse()};
    }
    float position() const { return dot(axis_, bodies_.separation_at_start()); }
    void take_over(const WheelJoint& old);
    void forget_impulses() { across_impulse_ = 0.0f, suspension_.forget_impulses(), axle_.forget_impulses(); }

    template <class Self, class Visitor>
    static void visit_members(Self& self, Visitor&& visit) {
        visit(self.def_, self.bodies_, self.suspension_, self.axle_, self.axis_, self.strut_, self.across_impulse_);
    }

private:
    // The geometry and the linear rows within the step.
    struct Strut {
        Vec2 axis;        // world, unit, rotated with A
        Vec2 separation;  // from A's anchor to B's, m
        JointRow along, across;
    };
    Strut strut(std::span<const SolverBody> bodies) const;

    WheelJointDef def_;
    JointBodies bodies_;
    JointDrive suspension_;
    JointDrive axle_;
    Vec2 axis_;                    // world, unit, at the start of the step
    Strut strut_;                  // of the last update_rows()
    float across_impulse_ = 0.0f;  // on B along perp(axis), N s
};

}  // namespace tumble
