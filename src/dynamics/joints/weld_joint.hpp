// Weld joint: constrains B's anchor to A's and the angle of B against A to the reference angle. An angular row (rad, N
// m s) and a point block (m, N s; joint_block.hpp), each an equality constraint or a spring.
#pragma once

#include <span>

#include "dynamics/rows/equality_row.hpp"
#include "dynamics/rows/joint_angle.hpp"
#include "dynamics/rows/joint_block.hpp"

namespace tumble {

class WeldJoint {
public:
    WeldJoint() = default;
    explicit WeldJoint(const WeldJointDef& def) : def_(def) {}

    void prepare(const BodyStore& bodies);
    void update_rows(std::span<const SolverBody> bodies);
    void warm_start(std::span<SolverBody> bodies) const;
    void solve(const JointContext& context, bool use_bias, std::span<SolverBody> bodies);

    // Calls visit(EqualityRow) for each equality constraint, at the present deltas of the bodies.
    template <class Visitor>
    void visit_equalities(std::span<const SolverBody> bodies, Visitor&& visit) {
        if (!def_.angular_spring)
            visit(make_equality(bodies_, kAngularRow, angle_.now(bodies_, bodies), angular_impulse_));
        if (!def_.linear_spring) visit_point(bodies_, bodies, impulse_, visit);
    }
    JointReaction reaction(float inv_h) const { return {inv_h * impulse_, inv_h * angular_impulse_}; }
    float position() const { return angle_.at_start(); }
    void take_over(const WeldJoint& old);
    void forget_impulses() { impulse_ = {}, angular_impulse_ = 0.0f; }

    template <class Self, class Visitor>
    static void visit_members(Self& self, Visitor&& visit) {
        visit(self.def_, self.bodies_, self.block_, self.angle_, self.impulse_, self.angular_impulse_);
    }

private:
    WeldJointDef def_;
    JointBodies bodies_;
    PointBlock block_;  // of the last update_rows()
    JointAngle angle_;
    Vec2 impulse_;                  // on B, N s
    float angular_impulse_ = 0.0f;  // on B, N m s
};

}  // namespace tumble
