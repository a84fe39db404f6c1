// Holds two anchors together: a soft point constraint in two dimensions, solved as a block, with a drive of the angle.
#pragma once

#include <span>

#include "dynamics/rows/joint_angle.hpp"
#include "dynamics/rows/joint_block.hpp"
#include "dynamics/rows/joint_drive.hpp"

namespace tumble {

class RevoluteJoint {
public:
    RevoluteJoint() = default;
    explicit RevoluteJoint(const RevoluteJointDef& def)
        : body_a_(def.body_a.index),
          body_b_(def.body_b.index),
          anchor_a_(def.anchor_a),
          anchor_b_(def.anchor_b),
          reference_angle_(def.reference_angle),
          drive_(def.spring, drive_motor(def.motor), def.limits) {}

    void prepare(const BodyStore& bodies);
    void warm_start(std::span<SolverBody> bodies) const;
    void solve(const JointContext& context, bool use_bias, std::span<SolverBody> bodies);
    JointReaction reaction(float inv_h) const { return {inv_h * impulse_, inv_h * drive_.impulse()}; }
    float position() const { return angle_.at_start(); }
    void take_over(const RevoluteJoint& old);
    void forget_impulses() { impulse_ = {}, drive_.forget_impulses(); }

    template <class Self, class Visitor>
    static void visit_members(Self& self, Visitor&& visit) {
        visit(self.body_a_, self.body_b_, self.anchor_a_, self.anchor_b_, self.reference_angle_, self.bodies_,
              self.angle_, self.drive_, self.impulse_);
    }

private:
    // Not the whole definition: scenes have thousands of hinges, and each step reads them all.
    std::uint32_t body_a_ = 0, body_b_ = 0;
    Vec2 anchor_a_, anchor_b_;
    float reference_angle_ = 0.0f;
    JointBodies bodies_;
    JointAngle angle_;
    JointDrive drive_;
    Vec2 impulse_;  // on B, N s
};

}  // namespace tumble
