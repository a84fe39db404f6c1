// The joint angle: the angle of B minus that of A, with whole turns counted, so that a hinge may have limits several
// turns apart.
#pragma once

#include <cmath>
#include <span>

#include "debug/check.hpp"
#include "dynamics/bodies/body_store.hpp"
#include "dynamics/rows/joint_bodies.hpp"

namespace tumble {

// The angle from rotation `a` to rotation `b`, rad in (-pi, pi]; NaN if one of them is not finite.
inline double relative_angle(Rotation a, Rotation b) {
    const double ac = a.c, as = a.s, bc = b.c, bs = b.s;
    return arc_tangent(ac * bs - as * bc, ac * bc + as * bs);
}

class JointAngle {
public:
    // Measures the angle at the start of the step, less `reference` (rad). Whole turns are chosen so that it is nearest
    // to the angle of the last step.
    void prepare(const BodyFrame& a, const BodyFrame& b, float reference) {
        const double wrapped = relative_angle(a.pose.rotation, b.pose.rotation) - static_cast<double>(reference);
        const double turns = std::nearbyint((static_cast<double>(angle_) - wrapped) / (2.0 * kPi));
        angle_ = static_cast<float>(wrapped + turns * (2.0 * kPi));
    }

    // The angle within the step, rad: that at the start plus the relative rotation since then (up to half a turn).
    float now(const JointBodies& joint, std::span<const SolverBody> all) const {
        TUMBLE_CHECK(joint.a < all.size());
        TUMBLE_CHECK(joint.b < all.size());
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
