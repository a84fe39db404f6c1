// The line between the anchors of a joint, and the row along it: the length of a rod, a spring or a rope.
#pragma once

#include <span>

#include "dynamics/rows/joint_row.hpp"

namespace tumble {

struct JointLine {
    Vec2 axis;  // unit, from A's anchor to B's; zero if the length is
    float length = 0.0f;

    static JointLine along(Vec2 separation) {
        const float size = tumble::length(separation);
        return size > 0.0f ? JointLine{(1.0f / size) * separation, size} : JointLine{};
    }
    static JointLine now(const JointBodies& joint, std::span<const SolverBody> all) {
        return along(joint.current_separation(all));
    }

    // Its velocity is that of the length.
    JointRow row(const JointBodies& joint, std::span<const SolverBody> all) const {
        return point_row(axis, joint.current_arm_a(all), joint.current_arm_b(all));
    }
};

}  // namespace tumble
