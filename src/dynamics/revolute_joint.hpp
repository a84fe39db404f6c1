// Holds two anchors together: a soft point constraint in two dimensions, solved as a block, with a drive of the angle.
#pragma once

#include <span>

#include "dynamics/joint_angle.hpp"
#include "dynamics/joint_block.hpp"
#include "dynamics/joint_drive.hpp"

namespace tumble {

class RevoluteJoint {
public:
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

private:
    // Not the whole definition: scenes have thousands of hinges, and each step reads them all.
    std::uint32_t body_a_, body_b_;
    Vec2 anchor_a_, anchor_b_;
    float reference_angle_;
    JointBodies bodies_;
    JointAngle angle_;
    JointDrive drive_;
    Vec2 impulse_;  // on B, N s
};

}  // namespace tumble
