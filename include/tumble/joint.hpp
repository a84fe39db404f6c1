// Definitions of joints, for World::create_joint().
//
// A joint constrains the relative motion of two bodies A and B and leaves some of it free. A free motion may have a
// spring, a motor and limits, in any combination.
//
// Anchors and axes are in the coordinates of their own body (m from the body's origin, not its centre of mass).
// Positions, speeds, forces and torques of a joint are those of B relative to A, and counter-clockwise is positive.
//
// A joint whose reaction (JointReaction) exceeds break_force (N) or break_torque (N m) is destroyed at the end of the
// step, with an event (StepEvents::broken_joints). Both must be greater than 0 and may be infinite. With
// collide_connected false the shapes of the two bodies do not collide. user_data is a number of the caller's: see
// World::user_data().
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <variant>

#include "tumble/id.hpp"
#include "tumble/math.hpp"

namespace tumble {

// How a world solves the equality constraints of its joints: coinciding anchors, rods, rails, rigid welds, ropes over
// pulleys, gears. Limits, motors and springs are iterated in both cases.
enum class JointSolver : std::uint8_t {
    // One after the other, with a softness of 60 Hz: O(joints), but joints open under load, and mechanisms lose energy.
    // The joints of pendulums and small linkages are exact while nothing touches their bodies: see the README beside
    // this file.
    iterative,

    // All at once, by a sparse factorization in each sub-step. Joints do not open, and pendulums and chains keep their
    // energy. A sub-step cannot resolve how links turn that are very light for the tension in them. They turn as if
    // they had more inertia, and a chain of such links loses energy.
    // For chains, ragdolls and robots it takes several times as long as the iteration; grids of many joints, and bodies
    // with hundreds of them, take far longer. Joints that contradict each other yield one after the other.
    // Contacts are iterated beside it. Piles of ragdolls come to rest. Light bodies between others of over 50 times
    // their mass may not, such as the planks of a bridge under a boulder or the thin legs of a heavy table: iterate
    // these.
    direct,
};

// The range of a free motion: rad or m, lower <= upper.
struct JointLimits {
    float lower = 0.0f;
    float upper = 0.0f;

    friend constexpr bool operator==(const JointLimits&, const JointLimits&) = default;
};

// A spring and damper, given by the oscillation that they alone would make of the two bodies. A step limits the
// frequency to 0.15 of the number of sub-steps in a second: 36 Hz for 60 steps of 4 sub-steps
// (WorldLimits::stiffest_spring).
struct JointSpring {
    float hertz = 1.0f;          // Hz, > 0
    float damping_ratio = 0.0f;  // >= 0; 0: no damping, 1: critical damping, no overshoot

    friend constexpr bool operator==(const JointSpring&, const JointSpring&) = default;
};

// A motor drives a free motion to a target speed with a bounded torque or force. With speed 0 it acts as friction.
struct AngularMotor {
    float speed = 0.0f;       // rad/s, counter-clockwise positive
    float max_torque = 0.0f;  // N m, >= 0

    friend constexpr bool operator==(const AngularMotor&, const AngularMotor&) = default;
};
struct LinearMotor {
    float speed = 0.0f;      // m/s, towards greater displacement or length
    float max_force = 0.0f;  // N, >= 0

    friend constexpr bool operator==(const LinearMotor&, const LinearMotor&) = default;
};

inline constexpr float kUnbreakable = std::numeric_limits<float>::infinity();

// Revolute joint (hinge): the two anchors coincide, and the bodies rotate about them. Its free motion is the joint
// angle: angle of B - angle of A - reference_angle, with whole turns counted.
struct RevoluteJointDef {
    BodyId body_a{};
    BodyId body_b{};
    Vec2 anchor_a{};
    Vec2 anchor_b{};
    float reference_angle = 0.0f;         // rad
    std::optional<JointLimits> limits{};  // of the joint angle, rad; it starts within half a turn of 0
    std::optional<AngularMotor> motor{};
    std::optional<JointSpring> spring{};  // its rest position is joint angle 0
    float break_force = kUnbreakable;     // N
    float break_torque = kUnbreakable;    // N m
    bool collide_connected = false;
    std::uint64_t user_data = 0;
};

// Prismatic joint (slider): B moves along an axis fixed in A and does not rotate relative to A. Its free motion is the
// displacement of B's anchor from A's along the axis.
struct PrismaticJointDef {
    BodyId body_a{};
    BodyId body_b{};
    Vec2 anchor_a{};
    Vec2 anchor_b{};
    Vec2 axis_a{1.0f, 0.0f};              // the direction in A's coordinates, of any length but 0
    float reference_angle = 0.0f;         // angle of B - angle of A, rad
    std::optional<JointLimits> limits{};  // of the displacement, m
    std::optional<LinearMotor> motor{};
    std::optional<JointSpring> spring{};  // its rest position is displacement 0
    float break_force = kUnbreakable;
    float break_torque = kUnbreakable;
    bool collide_connected = false;
    std::uint64_t user_data = 0;
};

// Distance joint: constrains the distance of the two anchors.
//   without spring and limits   a massless rod: the distance is `length`
//   with a spring               the distance is free, and `length` is the rest length of the spring
//   with limits                 the distance is free between the limits: a rope has limits from 0 to its length
struct DistanceJointDef {
    BodyId body_a{};
    BodyId body_b{};
    Vec2 anchor_a{};
    Vec2 anchor_b{};
    float length = 1.0f;                  // m, > 0
    std::optional<JointLimits> limits{};  // m, lower >= 0
    std::optional<LinearMotor> motor{};   // positive pushes the anchors apart; only with a spring or limits
    std::optional<JointSpring> spring{};
    float break_force = kUnbreakable;
    float break_torque = kUnbreakable;
    bool collide_connected = false;
    std::uint64_t user_data = 0;
};

// Weld joint: the two anchors coincide and the bodies do not rotate relative to each other, or both only softly, by a
// spring each.
struct WeldJointDef {
    BodyId body_a{};
    BodyId body_b{};
    Vec2 anchor_a{};
    Vec2 anchor_b{};
    float reference_angle = 0.0f;                 // angle of B - angle of A, rad
    std::optional<JointSpring> linear_spring{};   // of the anchors; none: rigid
    std::optional<JointSpring> angular_spring{};  // of the angle; none: rigid
    float break_force = kUnbreakable;
    float break_torque = kUnbreakable;
    bool collide_connected = false;
    std::uint64_t user_data = 0;
};

// Wheel joint: a wheel B on a suspension of chassis A. B's anchor moves along an axis fixed in A, with spring and
// limits; B rotates freely or by the motor.
struct WheelJointDef {
    BodyId body_a{};  // the chassis
    BodyId body_b{};  // the wheel
    Vec2 anchor_a{};
    Vec2 anchor_b{};
    Vec2 axis_a{0.0f, 1.0f};              // the suspension's direction in A's coordinates, of any length but 0
    std::optional<JointLimits> limits{};  // of the displacement of B's anchor from A's along the axis, m
    std::optional<AngularMotor> motor{};  // of the rotation of B relative to A
    std::optional<JointSpring> spring{};  // of the suspension; its rest position is displacement 0
    float break_force = kUnbreakable;
    float break_torque = kUnbreakable;
    bool collide_connected = false;
    std::uint64_t user_data = 0;
};

// Motor joint: drives the pose of B relative to A with a bounded force and torque.
//   with a spring      B's anchor to A's and B's angle to the reference angle, moving at the given velocities
//   without a spring   to the given velocities only; with velocity 0 it is dry friction, as in a scene seen from above
struct MotorJointDef {
    BodyId body_a{};
    BodyId body_b{};
    Vec2 anchor_a{};
    Vec2 anchor_b{};
    float reference_angle = 0.0f;   // angle of B - angle of A, rad
    Vec2 velocity{};                // of B's anchor relative to A's, world axes, m/s
    float angular_velocity = 0.0f;  // of B relative to A, rad/s
    float max_force = 0.0f;         // N, >= 0
    float max_torque = 0.0f;        // N m, >= 0
    std::optional<JointSpring> spring{};
    float break_force = kUnbreakable;
    float break_torque = kUnbreakable;
    bool collide_connected = false;
    std::uint64_t user_data = 0;
};

// Mouse joint: a spring pulls B's anchor to A's with a force of at most max_force. To drag B with a pointer, let A be a
// static body and move anchor_a by World::set_joint().
struct MouseJointDef {
    BodyId body_a{};
    BodyId body_b{};
    Vec2 anchor_a{};
    Vec2 anchor_b{};
    JointSpring spring{5.0f, 0.7f};
    float max_force = 0.0f;  // N, >= 0
    float break_force = kUnbreakable;
    float break_torque = kUnbreakable;
    bool collide_connected = true;
    std::uint64_t user_data = 0;
};

// Filter joint: the shapes of the two bodies do not collide. It constrains nothing.
struct FilterJointDef {
    BodyId body_a{};
    BodyId body_b{};
    std::uint64_t user_data = 0;
};

// Pulley joint: a rope from A over two wheels, fixed in the world, to B. The constraint is
//   distance of anchor_a from ground_anchor_a + ratio * distance of anchor_b from ground_anchor_b = length.
// With ratio 2 it is a block and tackle: B moves half as far as A, and the force on B is twice that on A. As in
// Box2D 2.4 the rope is rigid: it also pushes, where a real one would go slack. A side of length 0 has no direction and
// exerts no force: a body that is pulled up to its wheel moves past it, and hangs on the other side.
struct PulleyJointDef {
    BodyId body_a{};
    BodyId body_b{};
    Vec2 anchor_a{};
    Vec2 anchor_b{};
    DVec2 ground_anchor_a{};  // the wheels, world coordinates, m
    DVec2 ground_anchor_b{};
    float length = 1.0f;               // m, > 0
    float ratio = 1.0f;                // > 0
    float break_force = kUnbreakable;  // of the force on B
    float break_torque = kUnbreakable;
    bool collide_connected = false;
    std::uint64_t user_data = 0;
};

// Gear joint: couples the free motions of two joints, each revolute or prismatic. The constraint is
//   motion of joint_a + ratio * motion of joint_b = its value when the gear is created,
// where a motion is the angle (rad, whole turns counted) or the displacement (m) of the joint. Meshing wheels of radii
// r_a and r_b have the ratio r_b / r_a; a pinion of radius r and a rack, in this order, 1 / r or -1 / r.
//
// A gear acts on all bodies of both joints, and is destroyed with either joint. If World::set_joint() gives one of them
// other anchors or another axis, the gear continues from the present positions.
struct GearJointDef {
    BodyId body_a{};  // set by World: body B of joint_a
    BodyId body_b{};  // set by World: body B of joint_b
    JointId joint_a{};
    JointId joint_b{};
    float ratio = 1.0f;                 // not 0; m if only joint_b is revolute, 1/m if only joint_a is
    float break_force = kUnbreakable;   // of the force on body_b, if joint_b is prismatic
    float break_torque = kUnbreakable;  // of the torque on body_b, if joint_b is revolute
    bool collide_connected = false;
    std::uint64_t user_data = 0;
};

using JointDef = std::variant<RevoluteJointDef, DistanceJointDef, PrismaticJointDef, WeldJointDef, WheelJointDef,
                              MotorJointDef, MouseJointDef, FilterJointDef, PulleyJointDef, GearJointDef>;

// The points where a joint acts on its two bodies, world coordinates, m.
struct JointAnchors {
    DVec2 a;
    DVec2 b;
};

// The force and torque of a joint on body B in the last sub-step; body A gets the opposite. The exceptions are a
// pulley, whose force on A is 1 / ratio of that on B and along A's side of the rope, and a gear, whose effort on body_a
// along joint_a is 1 / ratio of that on body_b along joint_b.
struct JointReaction {
    Vec2 force;           // at B's anchor, world axes, N
    float torque = 0.0f;  // N m
};

// The free motion of a joint in the present state: see World::joint_motion().
struct JointMotion {
    double position = 0.0;  // rad or m
    double speed = 0.0;     // its change in time, rad/s or m/s
};

}  // namespace tumble
