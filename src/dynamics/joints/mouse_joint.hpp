// Mouse joint: a spring that pulls B's anchor to A's with a bounded force. A soft point constraint, solved as a block
// (joint_block.hpp); errors in m, impulses on B in N s along the world axes, of length h max_force at most.
#pragma once

#include <span>

#include "dynamics/rows/joint_block.hpp"

namespace tumble {

class MouseJoint {
public:
    MouseJoint() = default;
    explicit MouseJoint(const MouseJointDef& def) : def_(def) {}

    void prepare(const BodyStore& bodies);
    void update_rows(std::span<const SolverBody> bodies);
    void warm_start(std::span<SolverBody> bodies) const;
    void solve(const JointContext& context, bool use_bias, std::span<SolverBody> bodies);

    // It has no equality constraints.
    template <class Visitor>
    void visit_equalities(std::span<const SolverBody>, Visitor&&) {}
    JointReaction reaction(float inv_h) const { return {inv_h * impulse_, 0.0f}; }
    float position() const { return length(bodies_.separation_at_start()); }
    void take_over(const MouseJoint& old) { impulse_ = old.impulse_; }
    void forget_impulses() { impulse_ = {}; }

    template <class Self, class Visitor>
    static void visit_members(Self& self, Visitor&& visit) {
        visit(self.def_, self.bodies_, self.block_, self.impulse_);
    }

private:
    MouseJointDef def_;
    JointBodies bodies_;
    PointBlock block_;  // of the last update_rows()
    Vec2 impulse_;      // on B, N s
};

}  // namespace tumble
