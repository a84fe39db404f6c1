// What every joint knows of its two bodies: the frame of a point constraint, and how impulses act on them.
#pragma once

#include <cstdint>
#include <span>

#include "dynamics/bodies/body_store.hpp"
#include "dynamics/bodies/softness.hpp"

namespace tumble {

// What all joints share in a step.
struct JointContext {
    float h = 0.0f;  // sub-step, s
    float inv_h = 0.0f;
    Softness softness;

    // Of what a joint holds: soft with the bias, rigid without.
    Softness equality_softness(bool use_bias) const { return use_bias ? softness : Softness{}; }
};

// The vector at unit length; anything but zero has a direction.
inline Vec2 unit(Vec2 v) { return (1.0f / length(v)) * v; }

// Bodies and anchors of a joint during a step. Arms are in world axes at the start of the step.
struct JointBodies {
    std::uint32_t a = kStaticSolverBody;  // solver bodies
    std::uint32_t b = kStaticSolverBody;
    Vec2 inv_mass_a, inv_mass_b;  // along the axes of the world: bodies may be locked
    float inv_inertia_a = 0.0f, inv_inertia_b = 0.0f;
    float locked_mass = 0.0f;  // inverse, of the bodies that are locked along an axis
    Vec2 arm_a, arm_b;         // from the centres of mass to the anchors
    Vec2 center_difference;    // of B's centre from A's

    static JointBodies make(const BodyFrame& a, Vec2 anchor_a, const BodyFrame& b, Vec2 anchor_b) {
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

    // Locks, and bodies that do not turn, may leave two rows the same way to go, or one of them none: the matrix of a
    // block is singular then, or nearly so.
    bool may_be_singular() const { return locked_mass > 0.0f || inv_inertia_a + inv_inertia_b == 0.0f; }

    // Arms now, turned with the bodies.
    Vec2 current_arm_a(std::span<const SolverBody> all) const { return rotate(all[a].delta_rotation, arm_a); }
    Vec2 current_arm_b(std::span<const SolverBody> all) const { return rotate(all[b].delta_rotation, arm_b); }

    // From A's anchor to B's: at the start of the step, and now.
    Vec2 separation_at_start() const { return center_difference + arm_b - arm_a; }
    Vec2 current_separation(std::span<const SolverBody> all) const {
        return center_difference + (all[b].delta_position - all[a].delta_position) +
               (current_arm_b(all) - current_arm_a(all));
    }
};

}  // namespace tumble
