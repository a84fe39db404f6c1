// What every joint needs of its two bodies during a step: inverse masses and the arms of its anchors.
#pragma once

#include <cstdint>
#include <span>

#include "debug/check.hpp"
#include "dynamics/bodies/body_store.hpp"
#include "dynamics/bodies/softness.hpp"

namespace tumble {

// The values that all joints share in a step.
struct JointContext {
    float h = 0.0f;  // sub-step, s
    float inv_h = 0.0f;
    Softness softness;
    bool iterates_equalities = true;  // false: the direct solver solves them

    // Of the equality constraints of joints: soft in the pass with bias, rigid in the relaxing pass without.
    Softness equality_softness(bool use_bias) const { return use_bias ? softness : Softness{}; }
};

// The vector scaled to length 1; it must not be zero.
inline Vec2 unit(Vec2 v) {
    TUMBLE_CHECK(length(v) > 0.0f);
    return (1.0f / length(v)) * v;
}

// The bodies and anchors of a joint during a step. Arms are in world axes, as they were at the start of the step.
struct JointBodies {
    std::uint32_t a = kStaticSolverBody;  // indices of solver bodies
    std::uint32_t b = kStaticSolverBody;
    Vec2 inv_mass_a, inv_mass_b;  // 1/kg, along each world axis: 0 where a body is locked
    float inv_inertia_a = 0.0f, inv_inertia_b = 0.0f;
    float locked_mass = 0.0f;  // 1/kg: the sum of the inverse masses of bodies that are locked along an axis
    Vec2 arm_a, arm_b;         // from the centres of mass to the anchors, m
    Vec2 center_difference;    // from A's centre of mass to B's, m

    static JointBodies make(const BodyFrame& a, Vec2 anchor_a, const BodyFrame& b, Vec2 anchor_b) {
        TUMBLE_CHECK(!(a.inv_mass < 0.0f || b.inv_mass < 0.0f));
        TUMBLE_CHECK(!(a.inv_inertia < 0.0f || b.inv_inertia < 0.0f));
        JointBodies bodies{a.solver_body,
                           b.solver_body,
                           a.inv_masses(),
                           b.inv_masses(),
                           a.inv_inertia,
                           b.inv_inertia,
                           locked_part(a) + locked_part(b),
                           rotate(a.pose.rotation, anchor_a) - a.center_offset,
                           rotate(b.pose.rotation, anchor_b) - b.center_offset,
                           to_float(b.center - a.center)};
        return bodies;
    }

    static float locked_part(const BodyFrame& body) { return body.locks_x || body.locks_y ? body.inv_mass : 0.0f; }

    // True if the matrix of a block may be singular, or nearly so: with locked axes, or if neither body can rotate, two
    // rows may be left with one direction of motion, or a row with none.
    bool may_be_singular() const { return locked_mass > 0.0f || inv_inertia_a + inv_inertia_b == 0.0f; }

    // The arms now, rotated with the bodies since the start of the step.
    Vec2 current_arm_a(std::span<const SolverBody> all) const { return rotate(all[a].delta_rotation, arm_a); }
    Vec2 current_arm_b(std::span<const SolverBody> all) const { return rotate(all[b].delta_rotation, arm_b); }

    // From A's anchor to B's, m, world axes: at the start of the step, and now.
    Vec2 separation_at_start() const { return center_difference + arm_b - arm_a; }
    Vec2 current_separation(std::span<const SolverBody> all) const {
        return separation_of(current_arm_a(all), current_arm_b(all), all);
    }
    // The same, with the arms as they are now.
    Vec2 separation_of(Vec2 arm_a_now, Vec2 arm_b_now, std::span<const SolverBody> all) const {
        return center_difference + (all[b].delta_position - all[a].delta_position) + (arm_b_now - arm_a_now);
    }
};

}  // namespace tumble
