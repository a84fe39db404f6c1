// The table of scene fields: name, member, unit, range and meaning of everything a scene file can say, once.
//
// visit_fields(visitor, Type<T>) names the fields of T in the order in which they are written. The reader, the writer
// and the JSON schema are three visitors of it, so they cannot disagree. A visitor has
//   field(Field, member)             a value: number, text, vector, list, object, or an optional one of these
//   pair(Field, member, member)      two texts as an array
//   named(Field, member)             a list as an object whose keys are the names of its elements
//   json(Field, member)              any JSON value, kept as text
//   constant(Field, number)          a number that must be there
//   one_of(Field, member)            a variant whose alternatives are keys of this very object
//   exactly_one({names})             of these optional keys, one must be there
//   at_most_one(name, name)          of these optional keys, one or none
// and visit_alternatives(visitor, Type<Variant>) calls alternative<T>(name, description). Defaults are those of the
// structs themselves. Checks across fields are in check.cpp.
#pragma once

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string_view>
#include <utility>
#include <vector>

#include "tumble/scene.hpp"

namespace tumble::scene {

template <class T>
struct Type {};

// The closed range of a number, or of each component of a vector; `above_min` excludes the lower end.
struct Range {
    double min = 0.0;
    double max = 0.0;
    bool above_min = false;
    bool zero_in_queries = false;  // a distance query may have points and bare segments: 0 is allowed there
};

// Upper ends keep every product that a step forms (mass times length squared) inside the range of float.
inline constexpr double kFarthest = 1e9;  // positions, m
inline constexpr double kLargest = 1e5;   // sizes and shape coordinates, m
inline constexpr double kFastest = 1e6;   // velocities; also angles and what else has no natural end
inline constexpr double kLongest = 1e6;   // durations, s
inline constexpr double kMost = 1e6;      // copies that one repeater makes

inline constexpr Range kPosition{-kFarthest, kFarthest};
inline constexpr Range kCoordinate{-kLargest, kLargest};
inline constexpr Range kAny{-kFastest, kFastest};
inline constexpr Range kLength{0.0, kLargest, true};
inline constexpr Range kRadius{0.0, kLargest, true, true};
inline constexpr Range kRounding{0.0, kLargest};
inline constexpr Range kNotNegative{0.0, kFastest};
inline constexpr Range kPositive{0.0, kFastest, true};
inline constexpr Range kStrength{0.0, 1e12};
inline constexpr Range kTime{0.0, kLongest};
inline constexpr Range kInterval{0.0, kLongest, true};
inline constexpr Range kCount{1.0, kMost};
inline constexpr Range kBits{0.0, 4294967295.0};
inline constexpr Range kSeed{0.0, 0x1p64};

// What a text may be.
enum class Text { any, name, color };

struct Field {
    std::string_view name;
    std::string_view description;
    std::string_view unit = "";
    Range range = kAny;
    bool required = false;
    std::size_t min_items = 0;
    std::size_t max_items = 65535;
    Text text = Text::any;
};

// Enumerators and their names in files.
template <class Enum>
inline constexpr std::array<std::pair<Enum, std::string_view>, 0> kEnumNames{};
template <>
inline constexpr std::array<std::pair<BodyType, std::string_view>, 3> kEnumNames<BodyType>{
    {{BodyType::static_body, "static"}, {BodyType::kinematic_body, "kinematic"}, {BodyType::dynamic_body, "dynamic"}}};
template <>
inline constexpr std::array<std::pair<SceneJointType, std::string_view>, 8> kEnumNames<SceneJointType>{
    {{SceneJointType::revolute, "revolute"},
     {SceneJointType::distance, "distance"},
     {SceneJointType::prismatic, "prismatic"},
     {SceneJointType::weld, "weld"},
     {SceneJointType::wheel, "wheel"},
     {SceneJointType::motor, "motor"},
     {SceneJointType::mouse, "mouse"},
     {SceneJointType::filter, "filter"}}};

template <>
inline constexpr std::array<std::pair<SceneMoment, std::string_view>, 3> kEnumNames<SceneMoment>{
    {{SceneMoment::end, "end"}, {SceneMoment::always, "always"}, {SceneMoment::sometime, "sometime"}}};
template <>
inline constexpr std::array<std::pair<SceneEventKind, std::string_view>, 6> kEnumNames<SceneEventKind>{
    {{SceneEventKind::contact_begin, "contact_begin"},
     {SceneEventKind::contact_end, "contact_end"},
     {SceneEventKind::sensor_begin, "sensor_begin"},
     {SceneEventKind::sensor_end, "sensor_end"},
     {SceneEventKind::joint_broke, "joint_broke"},
     {SceneEventKind::fell_asleep, "fell_asleep"}}};

// A visitor that collects the keys of a struct.
struct FieldNames {
    void field(const Field& field, auto) { all.push_back(field.name); }
    void pair(const Field& field, auto, auto) { all.push_back(field.name); }
    void named(const Field& field, auto) { all.push_back(field.name); }
    void json(const Field& field, auto) { all.push_back(field.name); }
    void constant(const Field& field, int) { all.push_back(field.name); }
    void one_of(const Field&, auto) {}
    void exactly_one(std::initializer_list<std::string_view>) {}
    void at_most_one(std::string_view, std::string_view) {}

    std::vector<std::string_view> all;
};

// A visitor that collects the keys of a variant's alternatives, in the order of its types.
struct AlternativeNames {
    template <class Alternative>
    void alternative(std::string_view name, std::string_view) {
        all.push_back(name);
    }

    std::vector<std::string_view> all;
};

template <class V>
void visit_fields(V& v, Type<SceneSettings>) {
    v.field({"gravity", "Acceleration of all dynamic bodies.", "m/s^2"}, &SceneSettings::gravity);
    v.field({"steps_per_second", "Steps of the simulation in a second.", "Hz", {1.0, 1e5}},
            &SceneSettings::steps_per_second);
    v.field({"substeps", "Parts that the solver divides a step into.", "", {1.0, 1000.0}}, &SceneSettings::substeps);
    v.field({"duration", "Simulated time of a run.", "s", kTime}, &SceneSettings::duration);
    v.field({"seed", "Where the random numbers of scatter repeaters start.", "", kSeed}, &SceneSettings::seed);
    v.field({"sleeping", "Whether bodies at rest fall asleep."}, &SceneSettings::sleeping);
    v.field({"continuous", "Whether fast bodies are kept from passing through thin ones."}, &SceneSettings::continuous);
    v.field({"scale",
             "Size of a typical body: 1 for human scale, 0.02 for marbles. The stepper's own lengths, speeds and "
             "frequencies follow; the step rate is to be 1 / sqrt(scale) times as high.",
             "m",
             {1e-4, 1e4}},
            &SceneSettings::scale);
}

template <class V>
void visit_fields(V& v, Type<SceneCamera>) {
    v.field({"center", "World point in the middle of the frame; left out: everything in view.", "m", kPosition},
            &SceneCamera::center);
    v.field({"height", "Height of the world in the frame; left out: everything in view.", "m", {0.0, kFarthest, true}},
            &SceneCamera::height);
    v.field({.name = "follow", .description = "Name of a body that stays in the middle.", .text = Text::name},
            &SceneCamera::follow);
}

template <class V>
void visit_fields(V& v, Type<SceneMaterial>) {
    v.field({"density", "Mass of a square metre.", "kg/m^2", kNotNegative}, &SceneMaterial::density);
    v.field({"friction", "Of two surfaces, the square root of the product counts.", "", kNotNegative},
            &SceneMaterial::friction);
    v.field({"restitution",
             "Part of the speed that a bounce gives back; of two surfaces, the larger counts.",
             "",
             {0.0, 1.0}},
            &SceneMaterial::restitution);
    v.field({"rolling_resistance", "Lever arm of the resistance to rolling, in radii of the shape.", "", kNotNegative},
            &SceneMaterial::rolling_resistance);
    v.field({"tangent_speed", "Speed of a conveyor belt; positive carries what lies on top to the left.", "m/s"},
            &SceneMaterial::tangent_speed);
    v.field({.name = "color", .description = "#rgb or #rrggbb; left out: by type and name.", .text = Text::color},
            &SceneMaterial::color);
}

template <class V>
void visit_fields(V& v, Type<CircleGeometry>) {
    v.field({"radius", "Radius.", "m", kRadius, true}, &CircleGeometry::radius);
    v.field({"center", "Centre, in body coordinates.", "m", kCoordinate}, &CircleGeometry::center);
}

template <class V>
void visit_fields(V& v, Type<CapsuleGeometry>) {
    v.field({"from", "Centre of one end.", "m", kCoordinate, true}, &CapsuleGeometry::from);
    v.field({"to", "Centre of the other end.", "m", kCoordinate, true}, &CapsuleGeometry::to);
    v.field({"radius", "Half the thickness.", "m", kRadius, true}, &CapsuleGeometry::radius);
}

template <class V>
void visit_fields(V& v, Type<BoxGeometry>) {
    v.field({"size", "Outer width and height, rounding included.", "m", kLength, true}, &BoxGeometry::size);
    v.field({"radius", "Radius of the rounded corners, at most half the smaller side.", "m", kRounding},
            &BoxGeometry::radius);
    v.field({"center", "Centre, in body coordinates.", "m", kCoordinate}, &BoxGeometry::center);
    v.field({"angle", "Turn about the centre.", "degrees"}, &BoxGeometry::angle);
}

template <class V>
void visit_fields(V& v, Type<PolygonGeometry>) {
    v.field({"vertices", "Points in any order; their convex hull is the polygon.", "m", kCoordinate, true, 3},
            &PolygonGeometry::vertices);
    v.field({"radius", "Grows the polygon and rounds its corners.", "m", kRounding}, &PolygonGeometry::radius);
}

template <class V>
void visit_fields(V& v, Type<SegmentGeometry>) {
    v.field({"from", "One end.", "m", kCoordinate, true}, &SegmentGeometry::from);
    v.field({"to", "The other end.", "m", kCoordinate, true}, &SegmentGeometry::to);
}

template <class V>
void visit_fields(V& v, Type<ChainGeometry>) {
    v.field({"points", "Corners, one after the other.", "m", kCoordinate, true, 2}, &ChainGeometry::points);
    v.field({"loop", "Whether the last point is joined to the first."}, &ChainGeometry::loop);
    v.field({"two_sided", "Whether both sides are solid, not only the left of its direction."},
            &ChainGeometry::two_sided);
}

template <class V>
void visit_fields(V& v, Type<OutlineGeometry>) {
    v.field({"points", "Corners of a simple polygon, concave or not.", "m", kCoordinate, true, 3},
            &OutlineGeometry::points);
}

template <class V>
void visit_alternatives(V& v, Type<ShapeGeometry>) {
    v.template alternative<CircleGeometry>("circle", "A disc.");
    v.template alternative<CapsuleGeometry>("capsule", "A segment grown by a radius.");
    v.template alternative<BoxGeometry>("box", "A rectangle, rounded if it has a radius.");
    v.template alternative<PolygonGeometry>("polygon", "A convex polygon, rounded if it has a radius.");
    v.template alternative<SegmentGeometry>("segment", "A line that is solid on both sides and has no mass.");
    v.template alternative<ChainGeometry>("chain", "A line of segments, for grounds; it has no mass.");
    v.template alternative<OutlineGeometry>("outline", "A polygon that need not be convex.");
}

template <class V>
void visit_fields(V& v, Type<SceneFilter>) {
    v.field({"category", "Bits of what the shape is.", "", kBits}, &SceneFilter::category);
    v.field({"mask", "Bits of what it meets: each of two shapes must have one of the other's category.", "", kBits},
            &SceneFilter::mask);
    v.field({"group", "Of two shapes with the same one other than 0, this alone counts: positive ones meet, negative "
                      "ones do not.",
             "", {-1e6, 1e6}},
            &SceneFilter::group);
}

template <class V>
void visit_fields(V& v, Type<SceneShape>) {
    v.one_of({.name = "shape", .description = "What the shape is."}, &SceneShape::geometry);
    v.field(
        {.name = "material", .description = "Name of a material; left out: the defaults of one.", .text = Text::name},
        &SceneShape::material);
    v.field({"filter", "Which shapes it meets."}, &SceneShape::filter);
    v.field({"sensor", "Only notices what overlaps it; has no mass."}, &SceneShape::sensor);
    v.json({"custom", "Anything a user wants to keep."}, &SceneShape::custom);
}

template <class V>
void visit_fields(V& v, Type<GridRepeat>) {
    v.field({"columns", "Copies in a row.", "", kCount}, &GridRepeat::columns);
    v.field({"rows", "Rows, upwards.", "", kCount}, &GridRepeat::rows);
    v.field({"spacing", "From one column and one row to the next.", "m", kCoordinate}, &GridRepeat::spacing);
}

template <class V>
void visit_fields(V& v, Type<PyramidRepeat>) {
    v.field({"base", "Copies in the lowest row; each row has one fewer.", "", {1.0, 1413.0}, true},
            &PyramidRepeat::base);
    v.field({"spacing", "From one copy to the next in a row, and from row to row.", "m", kCoordinate},
            &PyramidRepeat::spacing);
}

template <class V>
void visit_fields(V& v, Type<RingRepeat>) {
    v.field({"count", "Copies on the ring, counter-clockwise from the right.", "", kCount, true}, &RingRepeat::count);
    v.field({"radius", "Radius of the ring.", "m", kLength}, &RingRepeat::radius);
    v.field({"turn", "Whether each copy is turned by its angle on the ring."}, &RingRepeat::turn);
}

template <class V>
void visit_fields(V& v, Type<ScatterRepeat>) {
    v.field({"count", "Copies in the box.", "", kCount, true}, &ScatterRepeat::count);
    v.field({"size", "Width and height of the box about the position.", "m", {0.0, kFarthest}}, &ScatterRepeat::size);
    v.field({"turn", "Whether each copy is turned by a random angle."}, &ScatterRepeat::turn);
    v.field({"separation", "Least distance between the positions of two copies.", "m", kRounding},
            &ScatterRepeat::separation);
}

template <class V>
void visit_alternatives(V& v, Type<SceneRepeat>) {
    v.template alternative<GridRepeat>("grid", "Rows and columns, from the position to the right and upwards.");
    v.template alternative<PyramidRepeat>("pyramid", "Rows that get shorter, from the position to the right.");
    v.template alternative<RingRepeat>("ring", "A circle about the position.");
    v.template alternative<ScatterRepeat>("scatter", "Random places in a box about the position.");
}

// The key of the alternative that a variant holds.
template <class Variant>
std::string_view alternative_name(const Variant& variant) {
    AlternativeNames names;
    visit_alternatives(names, Type<Variant>{});
    return names.all[variant.index()];
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
    v.field({"speed", "Speed that the motor tries to reach: degrees/s if it turns, m/s if it slides."},
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
void visit_fields(V& v, Type<SceneJoint>) {
    v.field({.name = "type",
             .description = "revolute: a hinge; distance: a rod, spring or rope; prismatic: a slider; weld: glue; wheel: a "
                            "hinge on a suspension; motor: drives or brakes, as seen from above; mouse: a spring that "
                            "pulls; filter: keeps the bodies from touching.",
             .required = true},
            &SceneJoint::type);
    v.field({.name = "name", .description = "Unique.", .text = Text::name}, &SceneJoint::name);
    v.pair({.name = "bodies", .description = "Names of the two bodies.", .required = true, .text = Text::name},
           &SceneJoint::body_a, &SceneJoint::body_b);
    v.field({"anchor", "World point, at load, that the joint acts on in both bodies.", "m", kPosition},
            &SceneJoint::anchor);
    v.field({"anchors", "The points that it acts on, each in the coordinates of its body.", "m", kCoordinate},
            &SceneJoint::anchors);
    v.at_most_one("anchor", "anchors");
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
    v.field({"length", "Of the rod; left out: the distance at load. Distance joints only.", "m", kLength},
            &SceneJoint::length);
    v.field({"limits", "Least and greatest joint angle (degrees, revolute), distance or way along the axis (m)."},
            &SceneJoint::limits);
    v.field({"motor", "Drives the second body against the first: turns it (revolute, wheel) or slides it (prismatic, "
                      "distance)."},
            &SceneJoint::motor);
    v.field({"spring", "Pulls the free motion to 0, or to the length; softens the point of a weld, motor or mouse joint."},
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
    v.json({"custom", "Anything a user wants to keep."}, &SceneJoint::custom);
}

template <class V>
void visit_fields(V& v, Type<SceneEvent>) {
    v.field({"at", "Time of a single event.", "s", kTime}, &SceneEvent::at);
    v.field({"every", "Interval of an event that happens again and again, from 0 on.", "s", kInterval}, &SceneEvent::every);
    v.exactly_one({"at", "every"});
    v.field({"until", "Time of the last repetition, or the end of a force or torque.", "s", kTime}, &SceneEvent::until);
    v.field({.name = "body", .description = "Name of the body that is acted on.", .text = Text::name}, &SceneEvent::body);
    v.field({.name = "joint", .description = "Name of the joint that is acted on.", .text = Text::name}, &SceneEvent::joint);
    v.field({"impulse", "Impulse at the centre of mass of the body.", "N s", {-1e12, 1e12}}, &SceneEvent::impulse);
    v.field({"angular_impulse", "Angular impulse on the body.", "N m s", {-1e12, 1e12}}, &SceneEvent::angular_impulse);
    v.field({"force", "Force at the centre of mass of the body, from then on.", "N", {-1e12, 1e12}}, &SceneEvent::force);
    v.field({"torque", "Torque on the body, from then on.", "N m", {-1e12, 1e12}}, &SceneEvent::torque);
    v.field({"velocity", "The body's velocity from then on.", "m/s"}, &SceneEvent::velocity);
    v.field({"angular_velocity", "The body's angular velocity from then on.", "degrees/s"}, &SceneEvent::angular_velocity);
    v.field({"motor_speed", "New speed of the joint's motor: degrees/s if it turns, m/s if it slides."}, &SceneEvent::motor_speed);
    v.field({"target", "World point that the mouse joint pulls to.", "m", kPosition}, &SceneEvent::target);
    v.field({"gravity", "Gravity from then on.", "m/s^2"}, &SceneEvent::gravity);
    v.field({"spawn", "A body that appears; with 'every', copies called name[0], name[1] and so on."}, &SceneEvent::spawn);
    v.field({.name = "despawn", .description = "Name of a body that goes.", .text = Text::name}, &SceneEvent::despawn);
    v.field({.name = "release", .description = "Name of a joint that goes.", .text = Text::name}, &SceneEvent::release);
    v.exactly_one({"impulse", "angular_impulse", "force", "torque", "velocity", "angular_velocity", "motor_speed", "target",
                   "gravity", "spawn", "despawn", "release"});
}

template <class V>
void visit_fields(V& v, Type<SceneExpectation>) {
    v.field({"at_rest_by", "Time by which nothing moves any more.", "s", kTime}, &SceneExpectation::at_rest_by);
    v.field({"max_penetration", "Depth that no overlap may pass.", "m", kRounding}, &SceneExpectation::max_penetration);
    v.field({"max_joint_error", "How far the anchors of a joint may part, of 'joint' or of every one.", "m", kRounding},
            &SceneExpectation::max_joint_error);
    v.field({"max_energy_gain", "How much kinetic and potential energy may grow above that at the start.", "J", kStrength},
            &SceneExpectation::max_energy_gain);
    v.field({.name = "body", .description = "Name of the body that is looked at.", .text = Text::name},
            &SceneExpectation::body);
    v.field({.name = "joint", .description = "Name of the joint that is looked at.", .text = Text::name},
            &SceneExpectation::joint);
    v.field({"inside", "Lower left and upper right corner of a box that holds the body's position.", "m", kPosition},
            &SceneExpectation::inside);
    v.field({"outside", "Lower left and upper right corner of a box that does not hold the body's position.", "m", kPosition},
            &SceneExpectation::outside);
    v.field({"height", "Least and greatest y of the body's position.", "m", kPosition}, &SceneExpectation::height);
    v.field({"speed", "Least and greatest speed of the body's centre of mass.", "m/s", kNotNegative},
            &SceneExpectation::speed);
    v.field({"angle", "Least and greatest angle of the body, between -180 and 180.", "degrees", {-180.0, 180.0}},
            &SceneExpectation::angle);
    v.field({.name = "touches", .description = "Name of a body that the body touches at least once.", .text = Text::name},
            &SceneExpectation::touches);
    v.field({.name = "never_touches", .description = "Name of a body that the body never touches.", .text = Text::name},
            &SceneExpectation::never_touches);
    v.field({"count", "Least and greatest number of bodies with their position in 'region', of the copies of 'body' or of all.",
             "", {0.0, 1e9}},
            &SceneExpectation::count);
    v.field({"region", "Lower left and upper right corner of the box that 'count' looks at.", "m", kPosition},
            &SceneExpectation::region);
    v.field({"event_count", "Least and greatest number of events of the kind 'event' so far, of 'body' or of all.", "", {0.0, 1e9}},
            &SceneExpectation::event_count);
    v.field({"event", "What 'event_count' counts."}, &SceneExpectation::event);
    v.field({"state_hash", "The state hash, 16 hexadecimal digits as run prints it."}, &SceneExpectation::state_hash);
    v.exactly_one({"at_rest_by", "max_penetration", "max_joint_error", "max_energy_gain", "inside", "outside", "height", "speed",
                   "angle", "touches", "never_touches", "count", "event_count", "state_hash"});
    v.field({"when", "When a claim of a state must hold: at the end, always, or sometime."}, &SceneExpectation::when);
    v.field({"at", "At this time alone.", "s", kTime}, &SceneExpectation::at);
    v.field({"from", "What is before does not count.", "s", kTime}, &SceneExpectation::from);
    v.field({"until", "What is after does not count.", "s", kTime}, &SceneExpectation::until);
}

template <class V>
void visit_fields(V& v, Type<Scene>) {
    v.field({"$schema", "Where editors find this schema."}, &Scene::schema);
    v.constant({.name = "format", .description = "Version of the file format.", .required = true}, 1);
    v.field({"name", "Names the output folder; left out: the file's name."}, &Scene::name);
    v.field({"description", "What there is to see."}, &Scene::description);
    v.field({"world", "The world and its run."}, &Scene::world);
    v.field({"camera", "What the frames show."}, &Scene::camera);
    v.named({"materials", "Surfaces, by name."}, &Scene::materials);
    v.field({.name = "bodies", .description = "The bodies.", .max_items = 1000000}, &Scene::bodies);
    v.field({.name = "joints", .description = "What ties bodies together.", .max_items = 1000000}, &Scene::joints);
    v.field({"timeline", "What happens during the run."}, &Scene::timeline);
    v.field({"expect", "What must be true; tested by check."}, &Scene::expect);
    v.json({"custom", "Anything a user wants to keep."}, &Scene::custom);
}

template <class T>
bool has_field(std::string_view name) {
    FieldNames names;
    visit_fields(names, Type<T>{});
    return std::find(names.all.begin(), names.all.end(), name) != names.all.end();
}

}  // namespace tumble::scene
