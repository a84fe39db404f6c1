// Keeps two anchors at a distance, as a weightless rod does: a soft constraint along the line between them.
#pragma once

#include <span>

#include "dynamics/joint_bodies.hpp"
#include "tumble/joint.hpp"

namespace tumble {

class DistanceJoint {
public:
    explicit DistanceJoint(const DistanceJointDef& def) : def_(def) {}

    void prepare(const BodyStore& bodies);
    void warm_start(std::span<SolverBody> bodies) const;
    void solve(const JointContext& context, bool use_bias, std::span<SolverBody> bodies);
    void store(const JointContext& context) { reaction_ = {context.inv_h * impulse_ * axis_, 0.0f}; }

    const JointReaction& reaction() const { return reaction_; }

private:
    DistanceJointDef def_;
    JointBodies bodies_;
    Vec2 axis_;             // from A's anchor to B's at the start of the step; zero if they coincide
    float impulse_ = 0.0f;  // along the axis on B, positive pushes, N s
    JointReaction reaction_;
};

}  // namespace tumble
