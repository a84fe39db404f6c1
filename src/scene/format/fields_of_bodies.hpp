// The scene fields of bodies, repeaters and joints. Part of fields.hpp.
#pragma once

#include "scene/format/fields_of_shapes.hpp"

namespace tumble::scene {

template <>
inline constexpr std::array<std::pair<BodyType, std::string_view>, 3> kEnumNames<BodyType>{
    {{BodyType::static_body, "static"}, {BodyType::kinematic_body, "kinematic"}, {BodyType::dynamic_body, "dynamic"}}};
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

inline constexpr Field kPatternAngle{
    "angle", "Rotation of the whole pattern about the body's position. The copies keep their own angles.", "degrees"};

template <class V>
void visit_fields(V& v, Type<GridRepeat>) {
    v.field({"columns", "Copies in a row.", "", kCount}, &GridRepeat::columns);
    v.field({"rows", "Number of rows, from the lowest upwards.", "", kCount}, &GridRepeat::rows);
    v.field({"spacing", "Distance from one column to the next and from one row to the next.", "m", kCoordinate},
            &GridRepeat::spacing);
    v.field(kPatternAngle, &GridRepeat::angle);
}

template <class V>
void visit_fields(V& v, Type<PyramidRepeat>) {
    v.field({"base", "Copies in the lowest row. Each row above has one fewer.", "", {1.0, 1413.0}, true},
            &PyramidRepeat::base);
    v.field({"spacing", "Distance from one copy to the next in a row, and from one row to the next.", "m", kCoordinate},
            &PyramidRepeat::spacing);
    v.field(kPatternAngle, &PyramidRepeat::angle);
}

template <class V>
void visit_fields(V& v, Type<RingRepeat>) {
    v.field({"count", "Copies on the ring, counter-clockwise from its rightmost point.", "", kCount, true},
            &RingRepeat::count);
    v.field({"radius", "Radius of the ring.", "m", kLength}, &RingRepeat::radius);
    v.field({"turn", "Whether each copy is rotated by its angle on the ring, measured from the first copy."},
            &RingRepeat::turn);
    v.field(kPatternAngle, &RingRepeat::angle);
}

template <class V>
void visit_fields(V& v, Type<ScatterRepeat>) {
    v.field({"count", "Number of copies.", "", kCount, true}, &ScatterRepeat::count);
    v.field({"size",
             "Width and height of the box around the body's position in which the copies are placed.",
             "m",
             {0.0, kFarthest}},
            &ScatterRepeat::size);
    v.field({"turn", "Whether each copy is rotated by a random angle."}, &ScatterRepeat::turn);
    v.field({"separation", "Least distance between the positions of two copies.", "m", kRounding},
            &ScatterRepeat::separation);
    v.field(kPatternAngle, &ScatterRepeat::angle);
}

template <class V>
void visit_alternatives(V& v, Type<SceneRepeat>) {
    v.template alternative<GridRepeat>(
        "grid", "Copies in rows and columns, from the body's position to the right and upwards.");
    v.template alternative<PyramidRepeat>(
        "pyramid",
        "Rows that shorten by one copy, each centred on the row below; the lowest starts at the body's position.");
    v.template alternative<RingRepeat>("ring", "Copies on a circle about the body's position.");
    v.template alternative<ScatterRepeat>("scatter", "Copies at random positions in a box about the body's position.");
}

template <class V>
void visit_fields(V& v, Type<SceneMass>) {
    v.field({"mass", "Mass of the body.", "kg", kPositive, true}, &SceneMass::mass);
    v.field({"center", "Centre of mass, in body coordinates.", "m", kCoordinate}, &SceneMass::center);
    v.field({"inertia", "Moment of inertia about the centre of mass. With 0 the body does not rotate.", "kg m^2",
             kStrength, true},
            &SceneMass::inertia);
}

template <class V>
void visit_fields(V& v, Type<SceneImage>) {
    v.field({.name = "file",
             .description = "Path of a PNG file, from the folder of the scene's file. Frames show the outline of the "
                            "image if there is no such file.",
             .required = true},
            &SceneImage::file);
    v.field({"center", "Middle of the image, in body coordinates.", "m", kCoordinate}, &SceneImage::center);
    v.field({"angle", "Rotation of the image in the body, counter-clockwise.", "degrees"}, &SceneImage::angle);
    v.field({"height", "Height of the image.", "m", kLength, true}, &SceneImage::height);
    v.field({"width", "Width of the image. Default: as the proportions of the file.", "m", kLength},
            &SceneImage::width);
    v.field({"flip", "Whether left and right are swapped."}, &SceneImage::flip);
    v.field({"opacity", "0 is invisible, 1 opaque.", "", {0.0, 1.0}}, &SceneImage::opacity);
    v.field({"order",
             "Images with higher numbers cover those with lower ones. Below 0 an image is behind all bodies.",
             "",
             {-1e6, 1e6}},
            &SceneImage::order);
}

template <class V>
void visit_fields(V& v, Type<SceneBody>) {
    v.field({.name = "name",
             .description = "Unique name. Copies are named name[0], name[1] and so on.",
             .text = Text::name},
            &SceneBody::name);
    v.field({"type",
             "static: never moves; kinematic: moves at its own velocity, whatever it touches; dynamic: moves under "
             "gravity, forces, contacts and joints."},
            &SceneBody::type);
    v.field({"position", "Position of the body's origin in the world.", "m", kPosition}, &SceneBody::position);
    v.field({"angle", "Rotation about the body's origin, counter-clockwise.", "degrees"}, &SceneBody::angle);
    v.field({"velocity", "Initial velocity of the centre of mass.", "m/s"}, &SceneBody::velocity);
    v.field({"angular_velocity", "Initial angular velocity, counter-clockwise.", "degrees/s"},
            &SceneBody::angular_velocity);
    v.field({"linear_damping", "Damping of the velocity: for small values, the fraction lost in a second.", "1/s",
             kNotNegative},
            &SceneBody::linear_damping);
    v.field({"angular_damping", "Damping of the angular velocity: for small values, the fraction lost in a second.",
             "1/s", kNotNegative},
            &SceneBody::angular_damping);
    v.field({"gravity_scale", "Factor by which the world's gravity is multiplied for this body."},
            &SceneBody::gravity_scale);
    v.field(
        {"bullet", "Whether a fast body is swept against dynamic bodies too, so that it does not pass through them."},
        &SceneBody::bullet);
    v.field({"awake", "false: a dynamic body starts asleep and stays at rest until something touches it."},
            &SceneBody::awake);
    v.field({"fixed_rotation", "Whether the body never rotates."}, &SceneBody::fixed_rotation);
    v.field({"lock_x", "Whether the body never moves along the world's x axis."}, &SceneBody::lock_x);
    v.field({"lock_y", "Whether the body never moves along the world's y axis."}, &SceneBody::lock_y);
    v.field({"enabled", "false: the body is drawn, but does not move and collides with nothing."}, &SceneBody::enabled);
    v.field({"allow_sleep", "false: the body never falls asleep, and neither do the bodies that touch it."},
            &SceneBody::allow_sleep);
    v.field({"allow_fast_rotation",
             "Whether the body may rotate by more than an eighth of a turn in a step. For round bodies."},
            &SceneBody::allow_fast_rotation);
    v.field({"mass", "Mass properties that replace those of the shapes."}, &SceneBody::mass);
    v.field({"repeat", "Pattern of copies of the body."}, &SceneBody::repeat);
    v.field({"trail", "Whether frames show the path of the body so far. No effect on the simulation."},
            &SceneBody::trail);
    v.field(
        {"skin",
         "Whether frames fill the closed loop through the copies of the body, as the skin of a soft body. No effect "
         "on the simulation."},
        &SceneBody::skin);
    v.field({"shapes", "Shapes that make up the body."}, &SceneBody::shapes);
    v.field({"images", "Pictures that frames show on the body. No effect on the simulation."}, &SceneBody::images);
    v.json({"custom", "Any JSON value: kept with the body, without effect on the simulation."}, &SceneBody::custom);
}

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
