// Distance joint: constrains the distance d of two anchors. One linear row along the line between them, positive when
// they move apart (m/s, N s).
//   rod:              d = length, an equality constraint
//   spring, limits:   a drive of d (joint_drive.hpp), where the spring's rest value is the length; a rope has limits
// Reference: Catto, "Soft Constraints", GDC 2011.
#pragma once

#include <span>

#include "dynamics/rows/equality_row.hpp"
#include "dynamics/rows/joint_drive.hpp"
#include "dynamics/rows/joint_line.hpp"

namespace tumble {

class DistanceJoint {
public:
    DistanceJoint() = default;
    explicit DistanceJoint(const DistanceJointDef& def)
        : def_(def), drive_(def.spring, drive_motor(def.motor), def.limits) {}

    void prepare(const BodyStore& bodies);
    // Whether it is the only joint with rows of its dynamic bodies in this step.
    void set_lone(bool is_lone) { is_lone_ = is_lone; }
    void update_rows(std::span<const SolverBody> bodies);
    void warm_start(std::span<SolverBody> bodies) const;
    void solve(const JointContext& context, bool use_bias, std::span<SolverBody> bodies);

    // Calls visit(EqualityRow) for each equality constraint, at the present deltas of the bodies.
    template <class Visitor>
    void visit_equalities(std::span<const SolverBody> bodies, Visitor&& visit) {
        if (!is_rod()) return;
        const LineRow at = LineRow::make(bodies_, bodies);
        visit(make_equality(bodies_, at.row, at.line.length - def_.length, rod_impulse_));
    }
    JointReaction reaction(float inv_h) const { return {inv_h * impulse() * line_.axis, 0.0f}; }
    float position() const { return line_.length; }
    void take_over(const DistanceJoint& old);
    void forget_impulses() { rod_impulse_ = 0.0f, drive_.forget_impulses(); }

    template <class Self, class Visitor>
    static void visit_members(Self& self, Visitor&& visit) {
        visit(self.def_, self.bodies_, self.drive_, self.line_, self.now_, self.rod_impulse_, self.is_lone_);
    }

private:
    // True without spring and limits: the length is an equality constraint. Otherwise the drive alone acts on it.
    bool is_rod() const { return !drive_.needs_value(); }
    float impulse() const { return rod_impulse_ + drive_.impulse(); }

    DistanceJointDef def_;
    JointBodies bodies_;
    JointDrive drive_;
    JointLine line_;            // at the start of the step
    LineRow now_;               // of the last update_rows()
    float rod_impulse_ = 0.0f;  // on B along the line, positive pushes apart, N s
    bool is_lone_ = false;      // in this step
};

}  // namespace tumble
