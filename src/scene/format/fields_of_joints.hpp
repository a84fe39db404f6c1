// The scene fields of joints. Part of fields.hpp.
#pragma once

#include "scene/format/field.hpp"

namespace tumble::scene {

template <>
inline constexpr std::array<std::pair<SceneJointType, std::string_view>, 10> kEnumNames<SceneJointType>{
    {{SceneJointType::revolute, "revolute"},
     {SceneJointType::distance, "distance"},
     {SceneJointType::prismatic, "prismatic"},
     {SceneJointType::weld, "weld"},
     {SceneJointType::wheel, "wheel"},
     {SceneJointType::motor, "motor"},
     {SceneJointType::mouse, "mouse"},
     {SceneJointType::filter, "filter"},
     {SceneJointType::pulley, "pulley"},
     {SceneJointType::gear, "gear"}}};

template <class V>
void visit_fields(V& v, Type<SceneJointMotor>) {
    v.field({"speed",
             "Speed that the motor drives at: degrees/s if it rotates, m/s if it slides. Counter-clockwise is "
             "positive, so a wheel that rolls to the right has a negative speed."},
            &SceneJointMotor::speed);
    v.field({"max_torque", "Largest torque of a motor that rotates.", "N m", kStrength}, &SceneJointMotor::max_torque);
    v.field({"max_force", "Largest force of a motor that slides.", "N", kStrength}, &SceneJointMotor::max_force);
    v.exactly_one({"max_torque", "max_force"});
}

template <class V>
void visit_fields(V& v, Type<SceneJointSpring>) {
    v.field({"hertz", "Natural frequency of the spring.", "Hz", kPositive, true}, &SceneJointSpring::hertz);
    v.field({"damping_ratio", "Damping ratio: 0 oscillates without end, 1 does not overshoot.", "", kNotNegative},
            &SceneJointSpring::damping_ratio);
}

template <class V>
void visit_fields(V& v, Type<JointRepeat>) {
    v.field({"columns",
             "Joints in a row. Each joint connects the copies that come next after those of the joint before: [0] and "
             "[1], then [1] and [2].",
             "", kCount},
            &JointRepeat::columns);
    v.field({"rows", "Number of rows of joints.", "", kCount}, &JointRepeat::rows);
    v.field({"row_step",
             "Number of copies from the first joint of a row to the first joint of the next row.",
             "",
             {0.0, kCount.max}},
            &JointRepeat::row_step);
    v.field({"spacing",
             "How far the anchor on a body that is not repeated moves, in coordinates of that body: along x from one "
             "column to the next, along y from one row to the next. Needs 'anchors'.",
             "m", kCoordinate},
            &JointRepeat::spacing);
}

template <class V>
void visit_fields(V& v, Type<SceneJoint>) {
    v.field({.name = "type",
             .description =
                 "revolute: a hinge; distance: a rod, spring or rope; prismatic: a slider; weld: glue; wheel: a hinge "
                 "on a suspension; motor: drives or brakes relative motion, as between a body and the ground seen from "
                 "above; mouse: a spring that pulls a body to a target; filter: stops the bodies from colliding; "
                 "pulley: a rope over two fixed wheels; gear: couples the motions of two joints.",
             .required = true},
            &SceneJoint::type);
    v.field({.name = "name",
             .description = "Unique name. Copies are named name[0], name[1] and so on.",
             .text = Text::name},
            &SceneJoint::name);
    v.pair(
        {.name = "bodies", .description = "Names of the two bodies. A gear has 'joints' instead.", .text = Text::name},
        &SceneJoint::body_a, &SceneJoint::body_b);
    v.pair({.name = "joints",
            .description = "Names of the two joints that a gear couples, each revolute or prismatic.",
            .text = Text::name},
           &SceneJoint::joint_a, &SceneJoint::joint_b);
    v.exactly_one({"bodies", "joints"});
    v.field({"anchor", "World point, at load, at which the joint acts on both bodies.", "m", kPosition},
            &SceneJoint::anchor);
    v.field({"anchors", "Points at which the joint acts on the bodies, each in the coordinates of its body.", "m",
             kCoordinate},
            &SceneJoint::anchors);
    v.at_most_one("anchor", "anchors");
    v.field({"ground_anchors", "World points, at load, of the two fixed wheels that the rope of a pulley runs over.",
             "m", kPosition},
            &SceneJoint::ground_anchors);
    v.field({"axis",
             "Direction of the free motion of a prismatic or wheel joint: a world direction at load or, with "
             "'anchors', a direction in the coordinates of the first body.",
             "", kCoordinate},
            &SceneJoint::axis);
    v.field({"reference_angle",
             "Angle of the second body minus that of the first at which the joint angle is 0. Default: the difference "
             "at load. For revolute, prismatic, weld and motor joints.",
             "degrees"},
            &SceneJoint::reference_angle);
    v.field({"length",
             "Length of a distance joint, or of a pulley's rope: the distance from the first body to its wheel plus "
             "'ratio' times the distance from the second body to its wheel. Default: the length at load.",
             "m", kLength},
            &SceneJoint::length);
    v.field({"ratio",
             "Pulley: the second body moves 1 / ratio times as far as the first, and is pulled with 'ratio' times the "
             "force. Gear: the motion of the first joint plus 'ratio' times that of the second (radians or m) is "
             "constant; the ratio is the second radius over the first for meshing wheels, and 1 / radius or -1 / "
             "radius for a pinion and its rack. Default: 1."},
            &SceneJoint::ratio);
    v.field({"limits",
             "Lower and upper limit of the joint angle (degrees, revolute), of the length (m, distance) or of the "
             "displacement along the axis (m, prismatic and wheel)."},
            &SceneJoint::limits);
    v.field({"motor",
             "Motor that drives the second body relative to the first: it rotates the body (revolute, wheel) or slides "
             "it (prismatic, distance)."},
            &SceneJoint::motor);
    v.field({"spring",
             "Spring that pulls the free motion to 0, or a distance joint to its length. In weld, motor and mouse "
             "joints it makes the connection of the anchors soft."},
            &SceneJoint::spring);
    v.field({"angular_spring", "Spring that makes the angle of a weld joint soft."}, &SceneJoint::angular_spring);
    v.field({"velocity", "Velocity of the second anchor relative to the first that a motor joint drives at.", "m/s"},
            &SceneJoint::velocity);
    v.field({"angular_velocity",
             "Angular velocity of the second body relative to the first that a motor joint drives at.", "degrees/s"},
            &SceneJoint::angular_velocity);
    v.field({"max_force", "Largest force of a motor or mouse joint.", "N", kStrength}, &SceneJoint::max_force);
    v.field({"max_torque", "Largest torque of a motor joint.", "N m", kStrength}, &SceneJoint::max_torque);
    v.field({"break_force", "Force at which the joint breaks and is removed.", "N", {0.0, 1e12, true}},
            &SceneJoint::break_force);
    v.field({"break_torque", "Torque at which the joint breaks and is removed.", "N m", {0.0, 1e12, true}},
            &SceneJoint::break_torque);
    v.field({"collide_connected", "Whether the two bodies collide with each other."}, &SceneJoint::collide_connected);
    v.field({"repeat",
             "Makes further joints between further copies of the bodies, or between further copies of the joints of a "
             "gear."},
            &SceneJoint::repeat);
    v.json({"custom", "Any JSON value: kept with the joint, without effect on the simulation."}, &SceneJoint::custom);
}

}  // namespace tumble::scene
