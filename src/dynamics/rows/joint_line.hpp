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
};

// The line at the present deltas of the bodies, and the row whose velocity is the rate of change of its length, m/s.
struct LineRow {
    JointLine line;
    JointRow row;

    static LineRow make(const JointBodies& joint, std::span<const SolverBody> all) {
        const Vec2 arm_a = joint.current_arm_a(all), arm_b = joint.current_arm_b(all);
        const JointLine line = JointLine::along(joint.separation_of(arm_a, arm_b, all));
        return {line, point_row(line.axis, arm_a, arm_b)};
    }
};

}  // namespace tumble
