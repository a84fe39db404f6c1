// Scenes: the portable description of a world as plain data, its JSON file, and the world built from it.
//
// Format 1 is described in README.md and published as scenes/scene.schema.json. A Scene keeps the doubles and degrees
// of its file; build_world() converts each number once, so that saving and loading give the same world bit for bit.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "tumble/body.hpp"
#include "tumble/joint.hpp"
#include "tumble/math.hpp"
#include "tumble/world.hpp"

namespace tumble {

// Where a scene file is wrong and how to mend it.
struct Diagnostic {
    enum class Severity { error, warning };
    Severity severity = Severity::error;
    std::string file;
    int line = 0;             // from 1; 0 if the place is unknown
    int column = 0;           // from 1, in bytes
    std::string pointer;      // JSON pointer of the value
    std::string message;      // "must be greater than 0, got -1"
    std::string source_line;  // the line of the file, for the caret
    std::string hint;         // may be empty
};

// "file:line:column: pointer: message", the source line, the caret, the hint.
std::string to_string(const Diagnostic& diagnostic);

// A scene that cannot be read: all its errors, at most 20; what() is their text.
class SceneError : public std::runtime_error {
public:
    explicit SceneError(std::vector<Diagnostic> diagnostics);
    std::vector<Diagnostic> diagnostics;
};

// A file that cannot be opened, read or written: path and reason.
class FileError : public std::runtime_error {
public:
    FileError(const std::filesystem::path& path, std::string_view reason);
};

struct SceneSettings {
    DVec2 gravity{0.0, -10.0};       // m/s^2
    double steps_per_second = 60.0;
    int substeps = 4;
    double duration = 5.0;           // s
    std::uint64_t seed = 1;
    bool sleeping = true;
    bool continuous = true;
};

struct SceneCamera {
    std::optional<DVec2> center;   // m; default: everything in view
    std::optional<double> height;  // m of the world from the lower to the upper edge
    std::string follow;            // name of a body, or empty
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

// Geometry of a shape in body coordinates; angles in degrees.
struct CircleGeometry { double radius = 0.0; DVec2 center; };
struct CapsuleGeometry { DVec2 from, to; double radius = 0.0; };
struct BoxGeometry { DVec2 size; double radius = 0.0; DVec2 center; double angle = 0.0; };
struct PolygonGeometry { std::vector<DVec2> vertices; double radius = 0.0; };
struct SegmentGeometry { DVec2 from, to; };
struct ChainGeometry { std::vector<DVec2> points; bool loop = false; bool two_sided = false; };
struct OutlineGeometry { std::vector<DVec2> points; };

struct SceneShape {
    std::variant<CircleGeometry, CapsuleGeometry, BoxGeometry, PolygonGeometry, SegmentGeometry, ChainGeometry,
                 OutlineGeometry>
        geometry;
    std::string material;                // name of a material; empty: the default one
    std::string custom;                  // JSON text, or empty
};

// Repeaters copy a body, starting at its position; the copies are named name[0], name[1], ...
struct GridRepeat { int columns = 1, rows = 1; DVec2 spacing{1.0, 1.0}; };      // row by row, upwards
struct PyramidRepeat { int base = 1; DVec2 spacing{1.0, 1.0}; };                // lowest row first, centred above it
struct RingRepeat { int count = 1; double radius = 1.0; bool turn = false; };   // about the position, from angle 0
struct ScatterRepeat { int count = 1; DVec2 size{1.0, 1.0}; bool turn = false; };  // seeded, in a box about the position

using SceneRepeat = std::variant<GridRepeat, PyramidRepeat, RingRepeat, ScatterRepeat>;

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
    std::optional<SceneRepeat> repeat;
    std::vector<SceneShape> shapes;
    std::string custom;
};

enum class SceneJointType { revolute, distance };

struct SceneJoint {
    SceneJointType type = SceneJointType::revolute;
    std::string name;
    std::string body_a, body_b;                           // names
    std::optional<DVec2> anchor;                          // world coordinates at load, for both bodies, or:
    std::optional<std::pair<DVec2, DVec2>> anchors;       // body coordinates of each
    std::optional<double> reference_angle;                // degrees; default: the angle at load
    std::optional<double> length;                         // m, distance joints; default: the distance at load
    bool collide_connected = false;
    std::string custom;
};

struct Scene {
    std::string schema;  // the "$schema" of the file, kept
    std::string name;
    std::string description;
    SceneSettings world;
    SceneCamera camera;
    std::vector<SceneMaterial> materials;
    std::vector<SceneBody> bodies;
    std::vector<SceneJoint> joints;
    std::string custom;                  // JSON text, or empty
};

// Reads a scene. Throws FileError (not readable) or SceneError (not valid). Warnings, if asked for, are appended.
Scene load_scene(const std::filesystem::path& file, std::vector<Diagnostic>* warnings = nullptr);
Scene parse_scene(std::string_view text, const std::string& file_name, std::vector<Diagnostic>* warnings = nullptr);

// The canonical text: keys in the schema's order, defaults left out, shortest round-trip numbers.
std::string to_json(const Scene& scene);
void save_scene(const Scene& scene, const std::filesystem::path& file);  // written aside, then renamed; throws FileError

// The JSON schema (Draft-07) of format 1, as published in scenes/scene.schema.json.
std::string scene_schema();

// xxHash64 of the canonical text without name, description, custom and $schema: equal simulations, equal hashes.
std::uint64_t scene_hash(const Scene& scene);

// One body of the built world: which entry of Scene::bodies it came from, and its name after repeating
// (empty for unnamed bodies, which are called body[i] in output, i counting the built bodies).
struct SceneInstance {
    BodyId id;
    std::size_t source = 0;
    std::string name;
};

struct SceneWorld {
    World world;
    std::vector<SceneInstance> bodies;  // in id order
    std::vector<JointId> joints;        // [scene.joints.size()]
};

// Throws SceneError if a name does not resolve or geometry is degenerate; the reader has checked both already.
SceneWorld build_world(const Scene& scene);

// What an importer could not carry over: the feature and how often it occurred.
struct ImportNote {
    std::string feature;
    int count = 0;
};

struct ImportedScene {
    Scene scene;
    std::vector<ImportNote> notes;
};

// Reads a R.U.B.E. (b2dJson) export. Throws FileError or SceneError.
ImportedScene import_rube(const std::filesystem::path& file);

}  // namespace tumble
