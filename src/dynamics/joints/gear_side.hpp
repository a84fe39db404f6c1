// One of the two motions that a gear ties together: the angle of a revolute joint, or the way of a prismatic one.
//
// Only changes are measured, from step to step and within a step. Whole turns are counted from sub-step to sub-step,
// and no sum grows with them.
#pragma once

#include <span>

#include "dynamics/rows/joint_angle.hpp"
#include "dynamics/rows/joint_row.hpp"

namespace tumble {

class GearSide {
public:
    GearSide() = default;
    explicit GearSide(const JointDef& joint);  // revolute or prismatic

    // Prepares the bodies, and returns how far the motion has gone on in the last step (rad or m); 0 the first time.
    double advance(const BodyStore& bodies, JointBodies& joint);

    JointRow row(const JointBodies& joint, std::span<const SolverBody> all) const;

    // How far it has gone on within the step. To be asked in each sub-step: angles are told up to half a turn.
    float follow(const JointBodies& joint, std::span<const SolverBody> all);

    // What an impulse per time along the row does to the second body.
    JointReaction reaction(float effort) const {
        return slides_ ? JointReaction{effort * axis_, 0.0f} : JointReaction{{}, effort};
    }

    // True if the same place has the same motion for another definition of the joint.
    bool measures_as(const GearSide& other) const;

    template <class Self, class Visitor>
    static void visit_members(Self& self, Visitor&& visit) {
        visit(self.body_a_, self.body_b_, self.slides_, self.anchor_a_, self.anchor_b_, self.axis_a_, self.axis_,
              self.motion_, self.moved_, self.is_known_);
    }

private:
    Vec2 axis_now(const JointBodies& joint, std::span<const SolverBody> all) const {
        return rotate(all[joint.a].delta_rotation, axis_);
    }

    std::uint32_t body_a_ = 0, body_b_ = 0;
    bool slides_ = false;
    Vec2 anchor_a_, anchor_b_, axis_a_;  // of what slides
    Vec2 axis_;                          // the same in the world, unit, at the start of the step
    double motion_ = 0.0;                // at the start of the step; an angle in (-pi, pi]
    double moved_ = 0.0;                 // in the step
    bool is_known_ = false;
};

}  // namespace tumble
