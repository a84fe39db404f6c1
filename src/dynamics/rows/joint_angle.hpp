// The angle of B against A, whole turns counted: a hinge may be limited to several turns.
#pragma once

#include <cmath>
#include <span>

#include "dynamics/bodies/body_store.hpp"
#include "dynamics/rows/joint_bodies.hpp"

namespace tumble {

// From one rotation to another, in (-pi, pi].
inline double relative_angle(Rotation a, Rotation b) {
    const double ac = a.c, as = a.s, bc = b.c, bs = b.s;
    return arc_tangent(ac * bs - as * bc, ac * bc + as * bs);
}

class JointAngle {
public:
    // The angle at the start of the step: of the turns that fit, the one nearest to the angle before.
    void prepare(const BodyFrame& a, const BodyFrame& b, float reference) {
        const double wrapped = relative_angle(a.pose.rotation, b.pose.rotation) - static_cast<double>(reference);
        const double turns = std::nearbyint((static_cast<double>(angle_) - wrapped) / (2.0 * kPi));
        angle_ = static_cast<float>(wrapped + turns * (2.0 * kPi));
    }

    // The angle now, within the step.
    float now(const JointBodies& joint, std::span<const SolverBody> all) const {
        return angle_ + static_cast<float>(relative_angle(all[joint.a].delta_rotation, all[joint.b].delta_rotation));
    }

    float at_start() const { return angle_; }

    template <class Self, class Visitor>
    static void visit_members(Self& self, Visitor&& visit) {
        visit(self.angle_);
    }

private:
    float angle_ = 0.0f;  // rad
};

}  // namespace tumble
