// Scenes: the portable description of a world as plain data.
//
// Format 1 of their files is described in scenes/README.md and published as scenes/scene.schema.json. A Scene keeps the
// doubles and degrees of its file. Files are read and written by scene_file.hpp, worlds built by scene_world.hpp.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "tumble/body.hpp"
#include "tumble/joint.hpp"
#include "tumble/math.hpp"
#include "tumble/scene_camera.hpp"
#include "tumble/world_def.hpp"

namespace tumble {

struct SceneSettings {
    DVec2 gravity{0.0, -10.0};  // m/s^2
    double steps_per_second = 60.0;
    int substeps = 4;
    double duration = 5.0;  // s
    std::uint64_t seed = 1;
    bool sleeping = true;
    bool continuous = true;
    JointSolver joints = JointSolver::iterative;
    ImpactModel impacts = ImpactModel::in_order;
    double scale = 1.0;  // m, the size of a typical body: see WorldDef
};

struct SceneMaterial {
    std::string name;
    double density = 1.0;
    double friction = 0.6;
    double restitution = 0.0;
    double rolling_resistance = 0.0;
    double tangent_speed = 0.0;
    std::string color;  // "#rgb" or "#rrggbb"; empty: chosen by type and name
};

// Geometry of a shape in body coordinates; lengths in m, angles in degrees.
struct CircleGeometry {
    double radius = 0.0;
    DVec2 center;
};
struct CapsuleGeometry {
    DVec2 from;
    DVec2 to;
    double radius = 0.0;
};
struct BoxGeometry {
    DVec2 size;           // outer, rounding included
    double radius = 0.0;  // of the rounded corners
    DVec2 center;
    double angle = 0.0;
};
struct PolygonGeometry {
    std::vector<DVec2> vertices;  // any order; the shape is their convex hull
    double radius = 0.0;          // grows the hull
};
struct SegmentGeometry {
    DVec2 from;
    DVec2 to;
};
struct ChainGeometry {
    std::vector<DVec2> points;
    bool loop = false;
    bool two_sided = false;  // else solid on the left of its direction
};
struct OutlineGeometry {
    std::vector<DVec2> points;  // a simple polygon, concave or not
};

using ShapeGeometry = std::variant<CircleGeometry, CapsuleGeometry, BoxGeometry, PolygonGeometry, SegmentGeometry,
                                   ChainGeometry, OutlineGeometry>;

struct SceneFilter {
    std::uint64_t category = 1;
    std::uint64_t mask = 0xffffffff;
    int group = 0;
};

struct SceneShape {
    ShapeGeometry geometry;
    std::string material;                 // name of a material; empty: the default one
    std::string custom;                   // JSON text, or empty
    std::optional<SceneFilter> filter{};  // which shapes it collides with; default: all
    bool sensor = false;
};

// Repeaters copy a body, starting at its position; the copies are named name[0], name[1], ... The angle (degrees)
// rotates the pattern about the position; the angles of the copies stay.
struct GridRepeat {  // row by row, upwards
    int columns = 1;
    int rows = 1;
    DVec2 spacing{1.0, 1.0};
    double angle = 0.0;
};
struct PyramidRepeat {  // lowest row first, each row centred above the one below and one shorter
    int base = 1;
    DVec2 spacing{1.0, 1.0};
    double angle = 0.0;
};
struct RingRepeat {  // about the position, counter-clockwise from the angle
    int count = 1;
    double radius = 1.0;
    bool turn = false;  // rotates each copy by its angle from the first
    double angle = 0.0;
};
struct ScatterRepeat {  // at random in a box about the position, drawn from the scene's seed
    int count = 1;
    DVec2 size{1.0, 1.0};
    bool turn = false;        // rotates each copy by a random angle
    double separation = 0.0;  // least distance between the positions of two copies
    double angle = 0.0;
};

using SceneRepeat = std::variant<GridRepeat, PyramidRepeat, RingRepeat, ScatterRepeat>;

struct SceneMass {
    double mass = 0.0;     // kg
    DVec2 center;          // body coordinates, m
    double inertia = 0.0;  // about the centre, kg m^2; 0: the body does not rotate
};

// A picture that frames show on a body, in body coordinates. It has no effect on the simulation.
struct SceneImage {
    std::string file;               // PNG, JPEG or BMP, relative to the folder of the scene's file
    DVec2 center;                   // m
    double angle = 0.0;             // degrees
    double height = 0.0;            // m
    std::optional<double> width{};  // m; default: as the file's proportions
    bool flip = false;              // swaps left and right
    double opacity = 1.0;           // 0 to 1
    int order = 0;                  // higher ones cover lower ones; below 0 behind all bodies

    // Where the file is; load_scene() sets it. Without it frames show the outline of the picture.
    std::filesystem::path path{};
};

struct SceneBody {
    std::string name;
    BodyType type = BodyType::dynamic_body;
    DVec2 position;
    double angle = 0.0;             // degrees
    DVec2 velocity;                 // of the centre of mass, m/s
    double angular_velocity = 0.0;  // degrees/s
    double linear_damping = 0.0;
    double angular_damping = 0.0;
    double gravity_scale = 1.0;
    bool bullet = false;
    bool awake = true;
    bool fixed_rotation = false;
    bool lock_x = false;
    bool lock_y = false;
    bool enabled = true;
    bool allow_sleep = true;
    bool allow_fast_rotation = false;
    std::optional<SceneMass> mass{};  // default: that of the shapes
    std::optional<SceneRepeat> repeat;
    bool trail = false;  // frames show the path of the body
    bool skin = false;   // frames fill the loop through the copies of the body
    std::vector<SceneShape> shapes;
    std::vector<SceneImage> images{};
    std::string custom;
};

enum class SceneJointType { revolute, distance, prismatic, weld, wheel, motor, mouse, filter, pulley, gear };

// [lower, upper] in files, both included.
struct SceneInterval {
    double lower = 0.0;
    double upper = 0.0;
};
struct SceneJointMotor {
    double speed = 0.0;                  // degrees/s (revolute, wheel) or m/s (distance, prismatic)
    std::optional<double> max_torque{};  // N m: revolute, wheel
    std::optional<double> max_force{};   // N: distance, prismatic
};
struct SceneJointSpring {
    double hertz = 0.0;
    double damping_ratio = 0.0;
};

// Copies a joint, row by row. From column to column the joint joins the next copies of its two bodies, from row to row
// the copies whose index is larger by `row_step`. A body without copies is joined by every copy of the joint. An anchor
// or axis in world coordinates is that of the first joint; its coordinates in the first of the joint's bodies that is a
// copy are the same for all copies. Of `anchors`, that on a body without copies moves by `spacing` from one joint to
// the next, so that each copy has a point of its own there. Copies are named name[0], name[1], ... A gear is repeated
// over the copies of its joints in the same way.
struct JointRepeat {
    int columns = 1;
    int rows = 1;
    int row_step = 0;
    DVec2 spacing;  // m, body coordinates: x for each column, y for each row
};

struct SceneJoint {
    SceneJointType type = SceneJointType::revolute;
    std::string name;
    std::string body_a, body_b;                      // names; empty for gears, which act on the bodies of their joints
    std::string joint_a, joint_b;                    // names, gears
    std::optional<DVec2> anchor;                     // world coordinates at load, for both bodies, or:
    std::optional<std::pair<DVec2, DVec2>> anchors;  // body coordinates of each
    std::optional<std::pair<DVec2, DVec2>> ground_anchors;  // of a pulley, world coordinates at load
    std::optional<DVec2> axis;              // world direction at load, or A's with `anchors`; prismatic, wheel
    std::optional<double> reference_angle;  // degrees; default: the angle at load
    std::optional<double> length;           // m, distance joints and pulleys; default: that at load
    std::optional<double> ratio;            // pulleys and gears, of motions in m and radians; default: 1
    std::optional<SceneInterval> limits;    // degrees (revolute) or m (distance, prismatic, wheel)
    std::optional<SceneJointMotor> motor;
    std::optional<SceneJointSpring> spring;          // of a weld: of its point
    std::optional<SceneJointSpring> angular_spring;  // welds
    std::optional<DVec2> velocity;                   // m/s, motor joints
    std::optional<double> angular_velocity;          // degrees/s, motor joints
    std::optional<double> max_force;                 // N, motor and mouse joints
    std::optional<double> max_torque;                // N m, motor joints
    std::optional<double> break_force;               // N
    std::optional<double> break_torque;              // N m
    bool collide_connected = false;
    std::optional<JointRepeat> repeat;
    std::string custom;
};

// A coordinate frame: a rotation, then a translation.
struct SceneFrame {
    DVec2 position;
    double angle = 0.0;  // degrees
};

// An action during the run, once (`at`, `when`) or repeatedly (`every`, `from` a time `until` a time); exactly one of
// the actions is set. An event on a body or joint that does not exist at that time has no effect.
struct SceneEvent {
    std::optional<double> at;         // s
    std::optional<double> every;      // s
    std::string when;                 // a condition (Expression): the event happens when it first holds
    std::optional<double> delay;      // s from then to the event; default: 0
    std::optional<SceneFrame> frame;  // of the coordinates in `when`; default: the world's
    std::optional<double> from;       // s: the first repetition; default: 0

    // s: the last repetition, or the end of a force or torque; default: the end of the run.
    std::optional<double> until;

    std::string body;                        // the body that impulses, forces and velocities act on
    std::string joint;                       // the joint that motor speeds and targets act on
    std::optional<DVec2> impulse;            // N s, at the centre of mass
    std::optional<double> angular_impulse;   // N m s
    std::optional<DVec2> force;              // N, at the centre of mass, in each step from `at` on
    std::optional<double> torque;            // N m, the same
    std::optional<DVec2> velocity;           // m/s
    std::optional<double> angular_velocity;  // degrees/s
    std::optional<double> motor_speed;       // degrees/s or m/s, as for the joint's motor
    std::optional<DVec2> target;             // m, world: where a mouse joint pulls its second body
    std::optional<DVec2> gravity;            // m/s^2
    std::optional<SceneBody> spawn;          // a new body; with `every` the bodies are named name[0], name[1], ...
    std::string despawn;                     // name of a body to destroy
    std::string release;                     // name of a joint to destroy
    bool stop = false;                       // ends the run
};

// When a claim on a state must hold: in the last state, in all states, or in at least one.
enum class SceneMoment { end, always, sometime };

enum class SceneEventKind {
    contact_begin,
    contact_end,
    contact_hit,
    sensor_begin,
    sensor_end,
    joint_broke,
    fell_asleep
};

using SceneBox = std::pair<DVec2, DVec2>;  // lower left and upper right corner, m

// A claim that ExpectationWatch (scene_run.hpp) evaluates: exactly one of the starred members is set.
struct SceneExpectation {
    std::optional<double> at_rest_by;       // * s
    std::optional<double> max_penetration;  // * m, of every contact
    std::optional<double> max_joint_error;  // * m between anchors, of `joint` or of all joints
    std::optional<double> max_energy_gain;  // * J of kinetic and potential energy above the first state
    std::string body;
    std::string joint;
    std::optional<SceneBox> inside;       // * contains the body's position
    std::optional<SceneBox> outside;      // * does not contain it
    std::optional<SceneInterval> height;  // * m, y of the body's position
    std::optional<SceneInterval> speed;   // * m/s, of its centre of mass
    std::optional<SceneInterval> angle;   // * degrees, in (-180, 180]
    std::string touches;                  // * another body, at least once
    std::string never_touches;            // * another body
    std::optional<SceneInterval> count;   // * bodies whose position is in `region`, of `body` and its copies or of all
    std::optional<SceneBox> region;
    std::optional<SceneInterval> event_count;  // * events so far of the kind `event`, of `body` or of all
    std::optional<SceneEventKind> event;
    std::string state_hash;  // * 16 hexadecimal digits
    std::string that;        // * a condition on a state (Expression); with `before`, of an order
    std::string before;      // a condition: `that` must hold in a state before the first in which this does
    std::optional<double> max_ms_per_step;  // * ms of wall clock, mean of the steps
    std::optional<double> max_time_ratio;   // * of the time of a step to that of `reference`
    std::string reference;                  // path of a scene file, relative to that of the scene
    std::string picture;                    // * path of a PNG file that the frame at `at` must equal
    std::optional<double> tolerance;        // of `picture`: levels, 0 to 255
    std::optional<SceneFrame> frame;        // in which boxes, heights and angles are measured; default: the world's
    SceneMoment when = SceneMoment::end;    // for claims on a state
    std::optional<double> at;               // s: in the state at this time; replaces `when`
    std::optional<double> from;             // s: earlier states do not count
    std::optional<double> until;            // s: later states do not count
};

// Another scene file whose bodies, joints, materials, events and claims become part of this scene. What applies to a
// whole world is left out: settings, camera, events of gravity, claims that name neither a body nor a joint.
struct SceneInclude {
    std::string file;    // relative to the folder of the including file
    DVec2 position;      // of its origin in this scene
    double angle = 0.0;  // degrees, about that point
    std::string prefix;  // put before each of its names
};

// A number of a scene file that is drawn at random: {"uniform": [1, 2]}.
struct SceneDraw {
    std::string pointer;      // JSON pointer of the number in its file: "/bodies/3/velocity/0"
    std::string key;          // the pointer with names in place of indices, and the prefix of an included file
    std::string declaration;  // JSON text
    double value = 0.0;       // what was drawn
};

struct Scene {
    std::string schema;  // the "$schema" of the file, kept
    std::string name;
    std::string description;
    SceneSettings world;
    SceneCamera camera;
    std::vector<SceneInclude> include;  // empty after loading: the entries of its files follow the scene's own
    std::vector<SceneMaterial> materials;
    std::vector<SceneBody> bodies;
    std::vector<SceneJoint> joints;
    std::vector<SceneEvent> timeline;
    std::vector<SceneExpectation> expect;
    std::string custom;            // JSON text, or empty
    std::vector<SceneDraw> draws;  // of its own file, then of the files that it includes (with an empty pointer)
};

}  // namespace tumble
