// Holds two anchors together: a soft point constraint in two dimensions, solved as a block.
#pragma once

#include <span>

#include "dynamics/joint_bodies.hpp"
#include "tumble/joint.hpp"

namespace tumble {

class RevoluteJoint {
public:
    explicit RevoluteJoint(const RevoluteJointDef& def) : def_(def) {}

    void prepare(const BodyStore& bodies);
    void warm_start(std::span<SolverBody> bodies) const;
    void solve(const JointContext& context, bool use_bias, std::span<SolverBody> bodies);
    void store(const JointContext& context) { reaction_ = {context.inv_h * impulse_, 0.0f}; }

    const JointReaction& reaction() const { return reaction_; }

private:
    RevoluteJointDef def_;
    JointBodies bodies_;
    Vec2 impulse_;  // on B, N s
    JointReaction reaction_;
};

}  // namespace tumble
