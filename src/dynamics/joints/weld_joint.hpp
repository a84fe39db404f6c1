// Glue: point and angle held, each rigidly or by a spring.
#pragma once

#include <span>

#include "dynamics/rows/joint_angle.hpp"
#include "dynamics/rows/joint_block.hpp"

namespace tumble {

class WeldJoint {
public:
    WeldJoint() = default;
    explicit WeldJoint(const WeldJointDef& def) : def_(def) {}

    void prepare(const BodyStore& bodies);
    void warm_start(std::span<SolverBody> bodies) const;
    void solve(const JointContext& context, bool use_bias, std::span<SolverBody> bodies);
    JointReaction reaction(float inv_h) const { return {inv_h * impulse_, inv_h * turning_impulse_}; }
    float position() const { return angle_.at_start(); }
    void take_over(const WeldJoint& old);
    void forget_impulses() { impulse_ = {}, turning_impulse_ = 0.0f; }

    template <class Self, class Visitor>
    static void visit_members(Self& self, Visitor&& visit) {
        visit(self.def_, self.bodies_, self.angle_, self.impulse_, self.turning_impulse_);
    }

private:
    WeldJointDef def_;
    JointBodies bodies_;
    JointAngle angle_;
    Vec2 impulse_;                  // N s
    float turning_impulse_ = 0.0f;  // N m s
};

}  // namespace tumble
