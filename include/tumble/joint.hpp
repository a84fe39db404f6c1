// Joints, as a user defines them. Anchors are in the coordinates of each body.
//
// A joint holds some of the relative motion of its bodies and leaves the rest free. What is free may have a spring, a
// motor and limits, in any combination. A joint whose reaction passes break_force or break_torque is destroyed at the
// end of the step, with an event.
#pragma once

#include <limits>
#include <optional>
#include <variant>

#include "tumble/id.hpp"
#include "tumble/math.hpp"

namespace tumble {

// Where a joint's free motion ends: rad or m, lower <= upper.
struct JointLimits {
    float lower = 0.0f;
    float upper = 0.0f;

    friend constexpr bool operator==(const JointLimits&, const JointLimits&) = default;
};

// A spring and damper by how they would move the two bodies on their own: frequency and damping ratio (0: swings on,
// 1: no overshoot). The stiffest is 0.15 of the sub-steps' frequency, 36 Hz at four of them sixty times a second: any
// stiffer one acts as that.
struct JointSpring {
    float hertz = 1.0f;          // > 0
    float damping_ratio = 0.0f;  // >= 0

    friend constexpr bool operator==(const JointSpring&, const JointSpring&) = default;
};

// Drives B against A at a speed, as far as its strength goes. At speed 0 it is friction.
struct AngularMotor {
    float speed = 0.0f;       // rad/s, counter-clockwise positive
    float max_torque = 0.0f;  // N m, >= 0

    friend constexpr bool operator==(const AngularMotor&, const AngularMotor&) = default;
};
struct LinearMotor {
    float speed = 0.0f;      // m/s, along the axis
    float max_force = 0.0f;  // N, >= 0

    friend constexpr bool operator==(const LinearMotor&, const LinearMotor&) = default;
};

inline constexpr float kUnbreakable = std::numeric_limits<float>::infinity();

// A hinge: holds two points together; the bodies turn about them.
struct RevoluteJointDef {
    BodyId body_a{};
    BodyId body_b{};
    Vec2 anchor_a{};
    Vec2 anchor_b{};
    float reference_angle = 0.0f;         // angle of B minus angle of A at joint angle 0, rad
    std::optional<JointLimits> limits{};  // of the joint angle, rad; whole turns count, from within half a turn of 0
    std::optional<AngularMotor> motor{};
    std::optional<JointSpring> spring{};  // towards joint angle 0
    float break_force = kUnbreakable;     // N
    float break_torque = kUnbreakable;    // N m
    bool collide_connected = false;       // whether the shapes of the two bodies touch each other
};

// A slider: B moves along an axis of A and does not turn against it.
struct PrismaticJointDef {
    BodyId body_a{};
    BodyId body_b{};
    Vec2 anchor_a{};
    Vec2 anchor_b{};
    Vec2 axis_a{1.0f, 0.0f};  // in A's coordinates, any length but 0
    float reference_angle = 0.0f;
    std::optional<JointLimits> limits{};  // of the way of B's anchor from A's along the axis, m
    std::optional<LinearMotor> motor{};
    std::optional<JointSpring> spring{};  // towards way 0
    float break_force = kUnbreakable;
    float break_torque = kUnbreakable;
    bool collide_connected = false;
};

// Keeps two points at a distance, as a weightless rod does. With a spring the length is what the spring wants; with
// limits the distance is free between them: a rope has limits from 0 to its length.
struct DistanceJointDef {
    BodyId body_a{};
    BodyId body_b{};
    Vec2 anchor_a{};
    Vec2 anchor_b{};
    float length = 1.0f;                  // m, > 0
    std::optional<JointLimits> limits{};  // m, lower >= 0
    std::optional<LinearMotor> motor{};   // positive pushes apart; needs a spring or limits, as a rod does not move
    std::optional<JointSpring> spring{};
    float break_force = kUnbreakable;
    float break_torque = kUnbreakable;
    bool collide_connected = false;
};

// Glue: neither point nor angle gives way, except by a spring.
struct WeldJointDef {
    BodyId body_a{};
    BodyId body_b{};
    Vec2 anchor_a{};
    Vec2 anchor_b{};
    float reference_angle = 0.0f;
    std::optional<JointSpring> linear_spring{};
    std::optional<JointSpring> angular_spring{};
    float break_force = kUnbreakable;
    float break_torque = kUnbreakable;
    bool collide_connected = false;
};

// A wheel on a suspension: B's anchor moves along an axis of A, and B turns freely or by a motor.
struct WheelJointDef {
    BodyId body_a{};  // the chassis
    BodyId body_b{};  // the wheel
    Vec2 anchor_a{};
    Vec2 anchor_b{};
    Vec2 axis_a{0.0f, 1.0f};
    std::optional<JointLimits> limits{};  // of the way along the axis, m
    std::optional<AngularMotor> motor{};
    std::optional<JointSpring> spring{};  // of the suspension, towards way 0
    float break_force = kUnbreakable;
    float break_torque = kUnbreakable;
    bool collide_connected = false;
};

// Drives B's anchor to A's and B's angle to the reference, or both to a relative velocity, with bounded strength.
// Without a spring it only knows velocities: at 0 it is the friction of things seen from above.
struct MotorJointDef {
    BodyId body_a{};
    BodyId body_b{};
    Vec2 anchor_a{};
    Vec2 anchor_b{};
    float reference_angle = 0.0f;
    Vec2 velocity{};                // of B's anchor against A's, world axes, m/s
    float angular_velocity = 0.0f;  // rad/s
    float max_force = 0.0f;         // N, >= 0
    float max_torque = 0.0f;        // N m, >= 0
    std::optional<JointSpring> spring{};
    float break_force = kUnbreakable;
    float break_torque = kUnbreakable;
    bool collide_connected = false;
};

// Pulls a point of B by a spring to a point of A, no harder than max_force: a mouse that drags, where A is the ground
// and anchor_a follows the pointer (World::set_joint).
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
};

// Keeps the shapes of two bodies from touching, and does nothing else.
struct FilterJointDef {
    BodyId body_a{};
    BodyId body_b{};
};

// A rope over two wheels that are fixed in the world: what the one side gives, the other takes. It holds
//   distance of anchor_a from ground_anchor_a + ratio * distance of anchor_b from ground_anchor_b = length.
// With ratio 2 the rope runs to B and back, a block and tackle: B moves half as far as A, and is pulled twice as hard.
// As in Box2D 2.4 it is rigid both ways: it pushes where a rope would hang loose. A side without length pulls nowhere:
// what is hauled up to its wheel passes it, and hangs on the other side.
struct PulleyJointDef {
    BodyId body_a{};
    BodyId body_b{};
    Vec2 anchor_a{};
    Vec2 anchor_b{};
    DVec2 ground_anchor_a{};  // world, m
    DVec2 ground_anchor_b{};
    float length = 1.0f;               // m, > 0
    float ratio = 1.0f;                // > 0
    float break_force = kUnbreakable;  // on B
    float break_torque = kUnbreakable;
    bool collide_connected = false;
};

// Teeth between two joints, each revolute or prismatic: keeps
//   motion of joint_a + ratio * motion of joint_b
// as it is when the gear is made, where a motion is the angle (rad, whole turns counted) or the way (m) of B against A.
// Wheels of radii r_a and r_b that mesh have the ratio r_b / r_a; a pinion and its rack, in this order, 1 / r or -1 /
// r. It pushes all bodies of both joints, and goes with either of them. Given anchors or an axis that are new, a joint
// goes on from where it is.
struct GearJointDef {
    BodyId body_a{};  // the second bodies of the two joints; World fills them in
    BodyId body_b{};
    JointId joint_a{};
    JointId joint_b{};
    float ratio = 1.0f;                 // any but 0; m if only B's joint turns, 1/m if only A's does
    float break_force = kUnbreakable;   // on B, where it slides
    float break_torque = kUnbreakable;  // on B, where it turns
    bool collide_connected = false;
};

using JointDef = std::variant<RevoluteJointDef, DistanceJointDef, PrismaticJointDef, WeldJointDef, WheelJointDef,
                              MotorJointDef, MouseJointDef, FilterJointDef, PulleyJointDef, GearJointDef>;

// The points of the two bodies that a joint acts on, world (m).
struct JointAnchors {
    DVec2 a;
    DVec2 b;
};

// What a joint did to body B in the last sub-step, and opposite to body A. A pulley pulls A by the same rope in a
// direction of its own, a gear acts on A by its other joint: there the ratio tells what A got.
struct JointReaction {
    Vec2 force;           // at the anchor, world axes, N
    float torque = 0.0f;  // N m
};

}  // namespace tumble
