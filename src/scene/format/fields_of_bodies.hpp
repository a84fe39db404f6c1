// The scene fields of bodies, their copies, and joints. Part of fields.hpp.
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
    "angle", "Turn of the whole pattern about the position; the copies keep their own angle.", "degrees"};

template <class V>
void visit_fields(V& v, Type<GridRepeat>) {
    v.field({"columns", "Copies in a row.", "", kCount}, &GridRepeat::columns);
    v.field({"rows", "Rows, upwards.", "", kCount}, &GridRepeat::rows);
    v.field({"spacing", "From one column and one row to the next.", "m", kCoordinate}, &GridRepeat::spacing);
    v.field(kPatternAngle, &GridRepeat::angle);
}

template <class V>
void visit_fields(V& v, Type<PyramidRepeat>) {
    v.field({"base", "Copies in the lowest row; each row has one fewer.", "", {1.0, 1413.0}, true},
            &PyramidRepeat::base);
    v.field({"spacing", "From one copy to the next in a row, and from row to row.", "m", kCoordinate},
            &PyramidRepeat::spacing);
    v.field(kPatternAngle, &PyramidRepeat::angle);
}

template <class V>
void visit_fields(V& v, Type<RingRepeat>) {
    v.field({"count", "Copies on the ring, counter-clockwise from the right.", "", kCount, true}, &RingRepeat::count);
    v.field({"radius", "Radius of the ring.", "m", kLength}, &RingRepeat::radius);
    v.field({"turn", "Whether each copy is turned by its angle on the ring, from the first one."}, &RingRepeat::turn);
    v.field(kPatternAngle, &RingRepeat::angle);
}

template <class V>
void visit_fields(V& v, Type<ScatterRepeat>) {
    v.field({"count", "Copies in the box.", "", kCount, true}, &ScatterRepeat::count);
    v.field({"size", "Width and height of the box about the position.", "m", {0.0, kFarthest}}, &ScatterRepeat::size);
    v.field({"turn", "Whether each copy is turned by a random angle."}, &ScatterRepeat::turn);
    v.field({"separation", "Least distance between the positions of two copies.", "m", kRounding},
            &ScatterRepeat::separation);
    v.field(kPatternAngle, &ScatterRepeat::angle);
}

template <class V>
void visit_alternatives(V& v, Type<SceneRepeat>) {
    v.template alternative<GridRepeat>("grid", "Rows and columns, from the position to the right and upwards.");
    v.template alternative<PyramidRepeat>("pyramid", "Rows that get shorter, from the position to the right.");
    v.template alternative<RingRepeat>("ring", "A circle about the position.");
    v.template alternative<ScatterRepeat>("scatter", "Random places in a box about the position.");
}

template <class V>
void visit_fields(V& v, Type<SceneMass>) {
    v.field({"mass", "Mass.", "kg", kPositive, true}, &SceneMass::mass);
    v.field({"center", "Centre of mass, in body coordinates.", "m", kCoordinate}, &SceneMass::center);
    v.field({"inertia", "About the centre of mass; 0: the body does not turn.", "kg m^2", kStrength, true},
            &SceneMass::inertia);
}

template <class V>
void visit_fields(V& v, Type<SceneBody>) {
    v.field(
        {.name = "name", .description = "Unique; copies are called name[0], name[1] and so on.", .text = Text::name},
        &SceneBody::name);
    v.field({"type", "static: never moves; kinematic: moves by its velocity alone; dynamic: is pushed about."},
            &SceneBody::type);
    v.field({"position", "Of the body's origin.", "m", kPosition}, &SceneBody::position);
    v.field({"angle", "Turn about the origin.", "degrees"}, &SceneBody::angle);
    v.field({"velocity", "Of the centre of mass.", "m/s"}, &SceneBody::velocity);
    v.field({"angular_velocity", "Turn in a second, counter-clockwise.", "degrees/s"}, &SceneBody::angular_velocity);
    v.field({"linear_damping", "Part of the velocity lost in a second, for small values.", "1/s", kNotNegative},
            &SceneBody::linear_damping);
    v.field({"angular_damping", "The same for the angular velocity.", "1/s", kNotNegative},
            &SceneBody::angular_damping);
    v.field({"gravity_scale", "Times the world's gravity."}, &SceneBody::gravity_scale);
    v.field({"bullet", "Kept from passing through dynamic bodies too, not only through others."}, &SceneBody::bullet);
    v.field({"awake", "false: a dynamic body starts asleep, at rest, until something touches it."}, &SceneBody::awake);
    v.field({"fixed_rotation", "Never turns, whatever pushes it."}, &SceneBody::fixed_rotation);
    v.field({"lock_x", "Never moves along the world's x axis."}, &SceneBody::lock_x);
    v.field({"lock_y", "Never moves along the world's y axis."}, &SceneBody::lock_y);
    v.field({"enabled", "false: it is drawn, but nothing meets it and it does not move."}, &SceneBody::enabled);
    v.field({"allow_sleep", "false: it never falls asleep, nor does what touches it."}, &SceneBody::allow_sleep);
    v.field({"allow_fast_rotation", "May turn by more than an eighth of a turn in a step: for round things."},
            &SceneBody::allow_fast_rotation);
    v.field({"mass", "In place of what the shapes weigh."}, &SceneBody::mass);
    v.field({"repeat", "Makes copies of the body."}, &SceneBody::repeat);
    v.field({"shapes", "What the body is made of."}, &SceneBody::shapes);
    v.json({"custom", "Anything a user wants to keep."}, &SceneBody::custom);
}

template <class V>
void visit_fields(V& v, Type<SceneJointMotor>) {
    v.field({"speed",
             "Speed that the motor tries to reach: degrees/s if it turns, m/s if it slides. Counter-clockwise is "
             "positive: a "
             "wheel that shall roll to the right turns at a negative speed."},
            &SceneJointMotor::speed);
    v.field({"max_torque", "Most that it may use where it turns.", "N m", kStrength}, &SceneJointMotor::max_torque);
    v.field({"max_force", "Most that it may use where it slides.", "N", kStrength}, &SceneJointMotor::max_force);
    v.exactly_one({"max_torque", "max_force"});
}

template <class V>
void visit_fields(V& v, Type<SceneJointSpring>) {
    v.field({"hertz", "Frequency of the oscillation.", "Hz", kPositive, true}, &SceneJointSpring::hertz);
    v.field({"damping_ratio", "0: oscillates on; 1: no overshoot.", "", kNotNegative},
            &SceneJointSpring::damping_ratio);
}

template <class V>
void visit_fields(V& v, Type<JointRepeat>) {
    v.field({"columns", "Copies in a row: each ties the copies of the bodies next to those that the one before ties.",
             "", kCount},
            &JointRepeat::columns);
    v.field({"rows", "Rows of copies.", "", kCount}, &JointRepeat::rows);
    v.field({"row_step", "Copies of the bodies from one row to the next.", "", {0.0, kCount.max}},
            &JointRepeat::row_step);
}

template <class V>
void visit_fields(V& v, Type<SceneJoint>) {
    v.field(
        {.name = "type",
         .description = "revolute: a hinge; distance: a rod, spring or rope; prismatic: a slider; weld: glue; wheel: a "
                        "hinge on a suspension; motor: drives or brakes, as seen from above; mouse: a spring that "
                        "pulls; filter: keeps the bodies from touching; pulley: a rope over two fixed wheels; gear: "
                        "ties the motions of two joints together.",
         .required = true},
        &SceneJoint::type);
    v.field({.name = "name", .description = "Unique.", .text = Text::name}, &SceneJoint::name);
    v.pair({.name = "bodies",
            .description = "Names of the two bodies; a gear has those of its joints.",
            .text = Text::name},
           &SceneJoint::body_a, &SceneJoint::body_b);
    v.pair({.name = "joints",
            .description = "Names of the two joints that a gear is on, each revolute or prismatic.",
            .text = Text::name},
           &SceneJoint::joint_a, &SceneJoint::joint_b);
    v.exactly_one({"bodies", "joints"});
    v.field({"anchor", "World point, at load, that the joint acts on in both bodies.", "m", kPosition},
            &SceneJoint::anchor);
    v.field({"anchors", "The points that it acts on, each in the coordinates of its body.", "m", kCoordinate},
            &SceneJoint::anchors);
    v.at_most_one("anchor", "anchors");
    v.field(
        {"ground_anchors", "World points, at load, of the wheels that the rope of a pulley runs over.", "m", kPosition},
        &SceneJoint::ground_anchors);
    v.field({"axis",
             "Direction of the free motion: of the world at load, or of the first body if its anchors are its own. "
             "Prismatic and wheel joints.",
             "", kCoordinate},
            &SceneJoint::axis);
    v.field({"reference_angle",
             "Angle of the second body minus that of the first at joint angle 0; left out: as they "
             "are at load. Revolute, prismatic, weld and motor joints.",
             "degrees"},
            &SceneJoint::reference_angle);
    v.field(
        {"length",
         "Of the rod of a distance joint; of the rope of a pulley: from the first body to its wheel, and 'ratio' times "
         "from the second body to its own. Left out: as at load.",
         "m", kLength},
        &SceneJoint::length);
    v.field(
        {"ratio",
         "Of a pulley: the second body moves by so much less than the first, and is pulled by so much more. Of a gear: "
         "the motion of the first joint (radians or m) and 'ratio' times that of the second make a sum that stays; "
         "meshing wheels have the second radius over the first, a pinion and its rack 1 over the radius, or -1. Left "
         "out: 1."},
        &SceneJoint::ratio);
    v.field({"limits", "Least and greatest joint angle (degrees, revolute), distance or way along the axis (m)."},
            &SceneJoint::limits);
    v.field({"motor",
             "Drives the second body against the first: turns it (revolute, wheel) or slides it (prismatic, "
             "distance)."},
            &SceneJoint::motor);
    v.field(
        {"spring", "Pulls the free motion to 0, or to the length; softens the point of a weld, motor or mouse joint."},
        &SceneJoint::spring);
    v.field({"angular_spring", "Softens the angle of a weld."}, &SceneJoint::angular_spring);
    v.field({"velocity", "Of the second body's anchor against the first's, that a motor joint drives at.", "m/s"},
            &SceneJoint::velocity);
    v.field({"angular_velocity", "Of the second body against the first, that a motor joint drives at.", "degrees/s"},
            &SceneJoint::angular_velocity);
    v.field({"max_force", "Most that a motor or mouse joint may pull.", "N", kStrength}, &SceneJoint::max_force);
    v.field({"max_torque", "Most that a motor joint may turn.", "N m", kStrength}, &SceneJoint::max_torque);
    v.field({"break_force", "Force at which the joint is destroyed.", "N", {0.0, 1e12, true}},
            &SceneJoint::break_force);
    v.field({"break_torque", "Torque at which the joint is destroyed.", "N m", {0.0, 1e12, true}},
            &SceneJoint::break_torque);
    v.field({"collide_connected", "Whether the two bodies touch each other."}, &SceneJoint::collide_connected);
    v.field({"repeat", "Makes a joint for each of many copies of its bodies, or of the joints of a gear."},
            &SceneJoint::repeat);
    v.json({"custom", "Anything a user wants to keep."}, &SceneJoint::custom);
}

}  // namespace tumble::scene
