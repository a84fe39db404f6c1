// Joints, as a user defines them. Anchors are in the coordinates of each body.
#pragma once

#include <variant>

#include "tumble/id.hpp"
#include "tumble/math.hpp"

namespace tumble {

// Holds two points together; the bodies turn freely about them.
struct RevoluteJointDef {
    BodyId body_a{};
    BodyId body_b{};
    Vec2 anchor_a{};
    Vec2 anchor_b{};
    float reference_angle = 0.0f;    // angle of B minus angle of A at joint angle 0, rad
    bool collide_connected = false;  // whether the shapes of the two bodies touch each other
};

// Keeps two points at a distance, as a weightless rod does.
struct DistanceJointDef {
    BodyId body_a{};
    BodyId body_b{};
    Vec2 anchor_a{};
    Vec2 anchor_b{};
    float length = 1.0f;  // m, > 0
    bool collide_connected = false;
};

using JointDef = std::variant<RevoluteJointDef, DistanceJointDef>;

// What a joint did to body B in the last sub-step, and opposite to body A.
struct JointReaction {
    Vec2 force;           // at the anchor, world axes, N
    float torque = 0.0f;  // N m
};

}  // namespace tumble
