// Eight revolute joints that are solved at the same time. Their drives have the same parts, none of their bodies is
// locked along an axis, none is the only joint of its bodies (../rows/lone_joint.hpp), and they move no body that they
// share. If there are fewer, the lanes left over repeat the first joint.
//
// The functions compute what RevoluteJoint computes for each joint, in the same order: the numbers are equal, though a
// zero may have another sign.
#pragma once

#include <cstdint>
#include <span>

#include "dynamics/bodies/body_lanes.hpp"
#include "dynamics/rows/joint_drive.hpp"

namespace tumble {

struct RevoluteBlock {
    BodyRow body_a[kLaneCount];
    BodyRow body_b[kLaneCount];
    std::uint8_t moved_a = 0, moved_b = 0;  // a bit for each lane whose body the joint can move
    bool has_spring = false, has_motor = false, has_limits = false;  // alike in all lanes

    Lanes inv_mass_a, inv_mass_b, inv_inertia_a, inv_inertia_b;
    Lanes arm_ax, arm_ay, arm_bx, arm_by;  // at the start of the step, m
    Lanes center_x, center_y;              // from A's centre of mass to B's at the start of the step, m
    Lanes impulse_x, impulse_y;            // of the point, on B, N s
    // Of the drive: valid if it has the part.
    Lanes angle;  // at the start of the step, rad
    Lanes spring_bias_rate, spring_mass_scale, spring_impulse_scale;
    Lanes motor_speed, motor_most;                                      // rad/s; N m s in a sub-step
    Lanes lower, upper;                                                 // rad
    Lanes spring_impulse, motor_impulse, lower_impulse, upper_impulse;  // N m s

    void set_parts(std::uint32_t parts) {  // JointDrive::parts()
        has_spring = parts & kSpringPart;
        has_motor = parts & kMotorPart;
        has_limits = parts & kLimitsPart;
    }
    bool has_drive() const { return has_spring || has_motor || has_limits; }
};

void warm_start_joints(const RevoluteBlock& block, std::span<SolverBody> bodies);
void solve_joints(RevoluteBlock& block, const JointContext& context, bool use_bias, std::span<SolverBody> bodies);

}  // namespace tumble
