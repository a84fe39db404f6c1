// Filter joint: no constraint rows. The shapes of its bodies do not collide, as may_collide() rejects their pairs.
#pragma once

#include <span>

#include "dynamics/rows/joint_bodies.hpp"

namespace tumble {

class FilterJoint {
public:
    FilterJoint() = default;
    explicit FilterJoint(const FilterJointDef&) {}

    void prepare(const BodyStore&) {}
    void update_rows(std::span<const SolverBody>) {}
    void warm_start(std::span<SolverBody>) const {}
    void solve(const JointContext&, bool, std::span<SolverBody>) {}

    // It has no equality constraints.
    template <class Visitor>
    void visit_equalities(std::span<const SolverBody>, Visitor&&) {}
    JointReaction reaction(float) const { return {}; }
    float position() const { return 0.0f; }
    void take_over(const FilterJoint&) {}
    void forget_impulses() {}

    template <class Self, class Visitor>
    static void visit_members(Self&, Visitor&&) {}
};

}  // namespace tumble
