// The joint angle: the angle of B minus that of A, with whole turns counted, so that a hinge may have limits several
// turns apart.
#pragma once

#include <cmath>
#include <span>

#include "debug/check.hpp"
#include "dynamics/bodies/body_store.hpp"
#include "dynamics/rows/joint_bodies.hpp"
#include "dynamics/rows/row_position.hpp"

namespace tumble {

// Sine and cosine of the angle from rotation `a` to rotation `b`, in double.
inline SinCos relative_sin_cos(Rotation a, Rotation b) {
    const double ac = a.c, as = a.s, bc = b.c, bs = b.s;
    return {ac * bs - as * bc, ac * bc + as * bs};
}

// That angle, rad in (-pi, pi]; NaN if one of them is not finite.
inline double relative_angle(Rotation a, Rotation b) {
    const SinCos v = relative_sin_cos(a, b);
    return arc_tangent(v.sin, v.cos);
}

// The arc tangent of |t| <= 1/8, a double or lanes of them, by its series. The first term left out is below 2e-14 of
// it.
template <class Number>
[[gnu::always_inline]] inline Number small_arc_tangent(const Number& t) {
    const Number z = t * t;
    const Number low = Number(1.0 / 3.0) - z * (Number(1.0 / 5.0) - z * Number(1.0 / 7.0));
    const Number high = Number(1.0 / 9.0) - z * (Number(1.0 / 11.0) - z * Number(1.0 / 13.0));
    return t - t * z * (low - z * z * z * high);
}

// relative_angle() to float precision, and in less time for the small angles of a sub-step.
inline float relative_turn(Rotation a, Rotation b) {
    const SinCos v = relative_sin_cos(a, b);
    const bool is_small = std::abs(v.sin) < 0.125 * v.cos;
    return static_cast<float>(is_small ? small_arc_tangent(v.sin / v.cos) : arc_tangent(v.sin, v.cos));
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
        return angle_ + relative_turn(all[joint.a].delta_rotation, all[joint.b].delta_rotation);
    }

    // Bounds of now() that take no arc tangent.
    PositionRange range(const JointBodies& joint, std::span<const SolverBody> all) const {
        TUMBLE_CHECK(joint.a < all.size());
        TUMBLE_CHECK(joint.b < all.size());
        constexpr float kRounding = 1e-6f;  // that of the relative rotation is below 2e-7
        const Rotation turn = rotation_between(all[joint.a].delta_rotation, all[joint.b].delta_rotation);
        const float largest = angle_bound(turn) + kRounding;
        return {angle_ - largest, angle_ + largest};
    }

    float at_start() const { return angle_; }

    template <class Self, class Visitor>
    static void visit_members(Self& self, Visitor&& visit) {
        visit(self.angle_);
    }

private:
    float angle_ = 0.0f;  // rad
};

// The joint angle as the position of a driven row (row_position.hpp).
struct AnglePosition {
    const JointAngle& angle;
    const JointBodies& joint;
    std::span<const SolverBody> all;
    PositionRange bounds;  // JointAngle::range() at the deltas of `all`

    float now() const { return angle.now(joint, all); }
    PositionRange range() const { return bounds; }
};

}  // namespace tumble
