// Pulley joint: constrains length_a + ratio length_b of a rope over two wheels that are fixed in the world. One coupled
// row (coupled_row.hpp) along both sides of the rope, positive when they grow (m/s, N s); each side is a line from its
// wheel, a point of the world, to its body's anchor.
#pragma once

#include <span>

#include "dynamics/rows/coupled_row.hpp"
#include "dynamics/rows/equality_row.hpp"
#include "dynamics/rows/joint_line.hpp"

namespace tumble {

class PulleyJoint {
public:
    PulleyJoint() = default;
    explicit PulleyJoint(const PulleyJointDef& def) : def_(def) {}

    void prepare(const BodyStore& bodies);
    void update_rows(std::span<const SolverBody> bodies);
    void warm_start(std::span<SolverBody> bodies) const;
    void solve(const JointContext& context, bool use_bias, std::span<SolverBody> bodies);

    // Calls visit(EqualityRow) for each equality constraint, at the present deltas of the bodies.
    template <class Visitor>
    void visit_equalities(std::span<const SolverBody> bodies, Visitor&& visit) {
        const Rope now = rope(bodies);
        visit(make_equality(bodies_, now.row, now.error, impulse_));
    }
    JointReaction reaction(float inv_h) const { return {inv_h * def_.ratio * impulse_ * line_b_.axis, 0.0f}; }
    float position() const { return line_a_.length; }
    void take_over(const PulleyJoint& old) { impulse_ = old.impulse_; }
    void forget_impulses() { impulse_ = 0.0f; }

    template <class Self, class Visitor>
    static void visit_members(Self& self, Visitor&& visit) {
        visit(self.def_, self.bodies_, self.line_a_, self.line_b_, self.rope_, self.impulse_);
    }

private:
    // The row along the rope, and its error.
    struct Rope {
        CoupledRow row;
        float error = 0.0f;  // m
    };
    Rope rope(std::span<const SolverBody> bodies) const;

    PulleyJointDef def_;
    CoupledBodies bodies_;       // of each side: the world as A, the body as B
    JointLine line_a_, line_b_;  // from wheel to body, at the start of the step
    Rope rope_;                  // of the last update_rows()
    float impulse_ = 0.0f;       // on A along its line, positive pushes away from the wheel, N s
};

}  // namespace tumble
