// One of the two motions that a gear couples: the angle of a revolute joint (rad), or the displacement of a prismatic
// one (m).
//
// It measures changes only, from step to step and within a step. Whole turns are counted from sub-step to sub-step, so
// that no number grows with the turns.
#pragma once

#include <span>
#include <variant>

#include "dynamics/rows/joint_angle.hpp"
#include "dynamics/rows/joint_row.hpp"
#include "tumble/joint.hpp"

namespace tumble {

// True if the joint has one free motion, which a gear can transmit.
inline bool can_be_geared(const JointDef& def) {
    return std::holds_alternative<RevoluteJointDef>(def) || std::holds_alternative<PrismaticJointDef>(def);
}

class GearSide {
public:
    GearSide() = default;
    explicit GearSide(const JointDef& joint);  // revolute or prismatic

    // Prepares `joint` for the step, and returns the change of the motion in the last step (rad or m), at first 0.
    double start_step(const BodyStore& bodies, JointBodies& joint);

    JointRow row(const JointBodies& joint, std::span<const SolverBody> all) const;

    // The change of the motion since the start of the step, rad or m. It must be called in every sub-step, as it tracks
    // an angle that changes by less than half a turn between two calls.
    float change_in_step(const JointBodies& joint, std::span<const SolverBody> all);

    // The force or torque on the second body of an effort (N or N m) along the row.
    JointReaction reaction(float effort) const {
        return slides_ ? JointReaction{effort * axis_, 0.0f} : JointReaction{{}, effort};
    }

    // True if both measure the same motion: the definitions of the joint have equal anchors and axes.
    bool measures_same_as(const GearSide& other) const;

    template <class Self, class Visitor>
    static void visit_members(Self& self, Visitor&& visit) {
        visit(self.body_a_, self.body_b_, self.slides_, self.anchor_a_, self.anchor_b_, self.axis_a_, self.axis_,
              self.motion_, self.change_, self.is_measured_);
    }

private:
    Vec2 axis_now(const JointBodies& joint, std::span<const SolverBody> all) const {
        return rotate(all[joint.a].delta_rotation, axis_);
    }

    std::uint32_t body_a_ = 0, body_b_ = 0;
    bool slides_ = false;
    Vec2 anchor_a_, anchor_b_, axis_a_;  // of a prismatic joint, body coordinates
    Vec2 axis_;                          // world, unit, at the start of the step
    double motion_ = 0.0;                // at the start of the step; an angle in (-pi, pi]
    double change_ = 0.0;                // since the start of the step
    bool is_measured_ = false;           // motion_ is that of the last step
};

}  // namespace tumble
