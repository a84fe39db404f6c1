// Motor joint: drives B's anchor and angle relative to A, with a bounded force and torque. An angular row and a point
// block (joint_block.hpp), each with a bound on the accumulated impulse, h times max_torque and max_force.
//   with a spring:     soft constraints of the angle to the reference angle and of B's anchor to A's, plus the wanted
//                      velocity
//   without a spring:  the relative velocity equals the wanted velocity; with 0 this is dry friction
#pragma once

#include <span>

#include "dynamics/rows/joint_angle.hpp"
#include "dynamics/rows/joint_block.hpp"

namespace tumble {

class MotorJoint {
public:
    MotorJoint() = default;
    explicit MotorJoint(const MotorJointDef& def) : def_(def) {}

    void prepare(const BodyStore& bodies);
    void update_rows(std::span<const SolverBody> bodies);
    void warm_start(std::span<SolverBody> bodies) const;
    void solve(const JointContext& context, bool use_bias, std::span<SolverBody> bodies);

    // It has no equality constraints.
    template <class Visitor>
    void visit_equalities(std::span<const SolverBody>, Visitor&&) {}
    JointReaction reaction(float inv_h) const { return {inv_h * impulse_, inv_h * angular_impulse_}; }
    float position() const { return angle_.at_start(); }
    void take_over(const MotorJoint& old);
    void forget_impulses() { impulse_ = {}, angular_impulse_ = 0.0f; }

    template <class Self, class Visitor>
    static void visit_members(Self& self, Visitor&& visit) {
        visit(self.def_, self.bodies_, self.block_, self.angle_, self.impulse_, self.angular_impulse_);
    }

private:
    MotorJointDef def_;
    JointBodies bodies_;
    PointBlock block_;  // of the last update_rows()
    JointAngle angle_;
    Vec2 impulse_;                  // on B, N s
    float angular_impulse_ = 0.0f;  // on B, N m s
};

}  // namespace tumble
