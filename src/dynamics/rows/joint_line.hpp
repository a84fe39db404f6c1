// The line between the anchors of a joint, and the row along it: of a rod, a spring or a rope.
#pragma once

#include <span>

#include "dynamics/rows/joint_row.hpp"

namespace tumble {

struct JointLine {
    Vec2 axis;            // unit, world, from A's anchor to B's; zero if the length is zero
    float length = 0.0f;  // m

    static JointLine along(Vec2 separation) {
        const float size = tumble::length(separation);
        return size > 0.0f ? JointLine{(1.0f / size) * separation, size} : JointLine{};
    }
    static JointLine now(const JointBodies& joint, std::span<const SolverBody> all) {
        return along(joint.current_separation(all));
    }

    // The row whose velocity is the rate of change of the length, m/s.
    JointRow row(const JointBodies& joint, std::span<const SolverBody> all) const {
        return point_row(axis, joint.current_arm_a(all), joint.current_arm_b(all));
    }
};

}  // namespace tumble
