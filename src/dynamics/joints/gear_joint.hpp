// Gear joint: constrains motion_a + ratio motion_b of two joints to its value at creation. One coupled row
// (coupled_row.hpp) along the motions of both, each the angle of a revolute joint (rad, N m s) or the displacement of a
// prismatic one (m, N s).
#pragma once

#include <span>

#include "dynamics/joints/gear_side.hpp"
#include "dynamics/rows/coupled_row.hpp"
#include "dynamics/rows/equality_row.hpp"

namespace tumble {

class GearJoint {
public:
    GearJoint() = default;
    GearJoint(const GearJointDef& def, const JointDef& joint_a, const JointDef& joint_b)
        : side_a_(joint_a), side_b_(joint_b) {
        bodies_.ratio = def.ratio;
    }

    void prepare(const BodyStore& bodies);
    void update_rows(std::span<const SolverBody> bodies);
    void warm_start(std::span<SolverBody> bodies) const;
    void solve(const JointContext& context, bool use_bias, std::span<SolverBody> bodies);

    // Calls visit(EqualityRow) for each equality constraint, at the present deltas of the bodies.
    template <class Visitor>
    void visit_equalities(std::span<const SolverBody> bodies, Visitor&& visit) {
        visit(make_equality(bodies_, row(bodies), measure_error(bodies), impulse_));
    }
    JointReaction reaction(float inv_h) const { return side_b_.reaction(inv_h * bodies_.ratio * impulse_); }
    float position() const { return static_cast<float>(slip_); }
    void take_over(const GearJoint& old);
    void forget_impulses() { impulse_ = 0.0f; }

    template <class Self, class Visitor>
    static void visit_members(Self& self, Visitor&& visit) {
        visit(self.side_a_, self.side_b_, self.bodies_, self.row_, self.slip_, self.error_, self.impulse_);
    }

private:
    CoupledRow row(std::span<const SolverBody> bodies) const;
    // Counts the turns of both sides: see GearSide::change_in_step().
    float measure_error(std::span<const SolverBody> bodies);

    GearSide side_a_, side_b_;
    CoupledBodies bodies_;
    CoupledRow row_;        // of the last update_rows()
    double slip_ = 0.0;     // the constraint's error at the start of the step, rad or m as motion_a
    float error_ = 0.0f;    // the error at the last update_rows()
    float impulse_ = 0.0f;  // along motion_a, N m s or N s
};

}  // namespace tumble
