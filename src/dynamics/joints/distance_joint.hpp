// Keeps two anchors at a distance, as a weightless rod, a spring or a rope does: one row along the line between them.
#pragma once

#include <span>

#include "dynamics/rows/joint_drive.hpp"
#include "dynamics/rows/joint_line.hpp"

namespace tumble {

class DistanceJoint {
public:
    DistanceJoint() = default;
    explicit DistanceJoint(const DistanceJointDef& def)
        : def_(def), drive_(def.spring, drive_motor(def.motor), def.limits) {}

    void prepare(const BodyStore& bodies);
    void warm_start(std::span<SolverBody> bodies) const;
    void solve(const JointContext& context, bool use_bias, std::span<SolverBody> bodies);
    JointReaction reaction(float inv_h) const { return {inv_h * impulse() * line_.axis, 0.0f}; }
    float position() const { return line_.length; }
    void take_over(const DistanceJoint& old);
    void forget_impulses() { rod_impulse_ = 0.0f, drive_.forget_impulses(); }

    template <class Self, class Visitor>
    static void visit_members(Self& self, Visitor&& visit) {
        visit(self.def_, self.bodies_, self.drive_, self.line_.axis, self.line_.length, self.rod_impulse_);
    }

private:
    // A rod holds its length itself; what has a spring or limits leaves it to the drive.
    bool is_rod() const { return !drive_.needs_value(); }
    float impulse() const { return rod_impulse_ + drive_.impulse(); }

    DistanceJointDef def_;
    JointBodies bodies_;
    JointDrive drive_;
    JointLine line_;            // at the start of the step
    float rod_impulse_ = 0.0f;  // along the axis on B, positive pushes, N s
};

}  // namespace tumble
