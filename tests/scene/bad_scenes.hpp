// Scenes that the reader must reject, with the pointer and a part of the message of the first error.
#pragma once

#include <string>
#include <vector>

namespace tumble::test {

struct BadScene {
    std::string text;
    std::string pointer;
    std::string message;
    std::string only_reader{};  // why a JSON schema cannot express the rule; empty: it can
};

// Rules that a schema cannot express.
inline const std::string kText = "the text itself: keys that occur twice, numbers beyond the range of a double";
inline const std::string kNames = "names: they must be unique, and what they refer to must exist";
inline const std::string kNumbers =
    "numbers beside each other: which is larger, how many copies they make, and what must be 0";
inline const std::string kGeometry = "geometry: what has no extent, or crosses itself";
inline const std::string kKinds = "keys that belong to some types of joints, events or claims only";
inline const std::string kNeeds = "keys that some types need";
inline const std::string kFiles = "included files: whether they exist, and their contents";
inline const std::string kForm = "texts of a form of their own: bytes of a name";

// One body with one shape.
inline std::string with_shape(const std::string& shape) {
    return R"({"format": 1, "bodies": [{"shapes": [)" + shape + "]}]}";
}

// Two bodies and a joint.
inline std::string with_joint(const std::string& keys) {
    return R"({"format": 1, "bodies": [{"name": "a"}, {"name": "b", "position": [2, 0]}], "joints": [{)" + keys + "}]}";
}

// Two bodies, a weld, a revolute and a prismatic joint of theirs, and a gear.
inline std::string with_gear(const std::string& keys) {
    const std::string bodies = R"("bodies": ["a", "b"], "anchor": [0, 0]}, {)";
    return with_joint(
        R"("type": "weld", "name": "glue", )" + bodies + R"("type": "revolute", "name": "hinge", )" + bodies +
        R"("type": "gear", )" + keys +
        R"(}, {"type": "prismatic", "name": "rail", "axis": [1, 0], "bodies": ["a", "b"], "anchor": [0, 0])");
}

// Two bodies and a claim, or an event.
inline std::string with_claim(const std::string& keys) {
    return R"({"format": 1, "bodies": [{"name": "a"}, {"name": "b"}], "expect": [{)" + keys + "}]}";
}
inline std::string with_event(const std::string& keys) {
    return R"({"format": 1, "bodies": [{"name": "a"}, {"name": "b"}], "timeline": [{)" + keys + "}]}";
}

inline const std::string kShape = "/bodies/0/shapes/0";

inline const std::vector<BadScene> kBadScenes = {
    // the document
    {"[]", "", "must be an object, got an empty array"},
    {"{}", "", "the key \"format\" is missing"},
    {R"({"format": 2})", "/format", "must be 1, got 2"},
    {R"({"format": "1"})", "/format", "must be 1, got \"1\""},
    {R"({"format": 1, "bodys": []})", "/bodys", "unknown key \"bodys\""},
    {R"({"format": 1, "name": 5})", "/name", "must be a string, got 5"},
    {R"({"format": 1, "bodies": {}})", "/bodies", "must be an array, got an object"},
    {R"({"format": 1, "world": null})", "/world", "must be an object, got null"},
    {R"({"format": 1, "name": "a", "name": "b"})", "/name", "this key occurs twice", kText},
    // numbers
    {R"({"format": 1, "world": {"gravity": [0]}})", "/world/gravity", "must be a vector [x, y], got an array of 1"},
    {R"({"format": 1, "world": {"gravity": [0, "1"]}})", "/world/gravity/1", "must be a number, got \"1\""},
    {R"({"format": 1, "world": {"gravity": [0, 1e300]}})", "/world/gravity/1", "must be at most 1000000, got 1e+300"},
    {R"({"format": 1, "world": {"substeps": 0}})", "/world/substeps", "must be at least 1, got 0"},
    {R"({"format": 1, "world": {"substeps": 2.5}})", "/world/substeps", "must be a whole number, got 2.5"},
    {R"({"format": 1, "world": {"seed": -1}})", "/world/seed", "must be at least 0, got -1"},
    {R"({"format": 1, "world": {"seed": 18446744073709551616}})", "/world/seed",
     "must be at most"},  // 2^64: no validator's integer
    {R"({"format": 1, "bodies": [{"angle": 1, "angle": 2}]})", "/bodies/0/angle", "this key occurs twice", kText},
    {R"({"format": 1, "world": {"sleeping": 1}})", "/world/sleeping", "must be true or false, got 1"},
    {R"({"format": 1, "camera": {"height": 0}})", "/camera/height", "must be greater than 0, got 0"},
    {R"({"format": 1, "materials": {"a": {"restitution": 1.5}}})", "/materials/a/restitution",
     "must be at most 1, got 1.5"},
    {R"({"format": 1, "materials": {"a": {"color": "red"}}})", "/materials/a/color", "must be a colour"},
    {R"({"format": 1, "materials": {"a/b": {"density": -1}}})", "/materials/a~1b/density",
     "must be at least 0, got -1"},
    // bodies
    {R"({"format": 1, "bodies": [{"type": "rigid"}]})", "/bodies/0/type", "must be one of static, kinematic, dynamic"},
    {R"({"format": 1, "bodies": [{"name": ""}]})", "/bodies/0/name", "must be a name of 1 to 256 bytes"},
    {R"({"format": 1, "bodies": [{"name": "a"}, {"name": "a"}]})", "/bodies/1/name", "is already the name of /bodies/0",
     kNames},
    {R"({"format": 1, "bodies": [{"name": "a", "repeat": {"ring": {"count": 2}}}, {"name": "a[1]"}]})",
     "/bodies/1/name", "is already the name of a copy", kNames},
    {R"({"format": 1, "bodies": [{"repeat": {}}]})", "/bodies/0/repeat",
     "needs one of the keys grid, pyramid, ring, scatter"},
    {R"({"format": 1, "bodies": [{"repeat": {"ring": {"count": 2}, "grid": {}}}]})", "/bodies/0/repeat/ring",
     "only one of them is allowed"},
    {R"({"format": 1, "bodies": [{"repeat": {"pyramid": {"base": 0}}}]})", "/bodies/0/repeat/pyramid/base",
     "must be at least 1, got 0"},
    {R"({"format": 1, "bodies": [{"repeat": {"grid": {"columns": 1000000, "rows": 1000000}}}]})", "/bodies/0",
     "1000000000000", kNumbers},
    {R"({"format": 1, "bodies": [{"repeat": {"scatter": {"count": 50, "size": [1, 1], "separation": 1}}}]})",
     "/bodies/0/repeat", "found room for only", kNumbers},
    {R"({"format": 1, "bodies": [{"awake": false, "velocity": [0, 1]}]})", "/bodies/0/awake",
     "a sleeping body must be at rest", kNumbers},
    {R"({"format": 1, "timeline": [{"at": 1, "spawn": {"awake": false, "angular_velocity": 1}}]})",
     "/timeline/0/spawn/awake", "a sleeping body must be at rest", kNumbers},
    // shapes
    {with_shape("{}"), kShape, "needs one of the keys circle, capsule, box, polygon, segment, chain, outline"},
    {with_shape(R"({"circle": {"radius": 1}, "box": {"size": [1, 1]}})"), kShape + "/box",
     "only one of them is allowed"},
    {with_shape(R"({"circle": {}})"), kShape + "/circle", "the key \"radius\" is missing"},
    {with_shape(R"({"circle": {"radius": -1}})"), kShape + "/circle/radius", "must be greater than 0, got -1"},
    {with_shape(R"({"circle": {"radius": 0}})"), kShape + "/circle/radius", "must be greater than 0, got 0"},
    {with_shape(R"({"circle": {"radius": 1e-60}})"), kShape + "/circle", "the radius 1e-60 is too small", kGeometry},
    {with_shape(R"({"box": {"size": [0, 1]}})"), kShape + "/box/size/0", "must be greater than 0, got 0"},
    {with_shape(R"({"box": {"size": [1, 1], "radius": 0.6}})"), kShape + "/box", "more than half the smaller side",
     kNumbers},
    {with_shape(R"({"polygon": {"vertices": [[0, 0], [1, 0]]}})"), kShape + "/polygon/vertices",
     "must be an array of at least 3, got an array of 2"},
    {with_shape(R"({"polygon": {"vertices": [[0, 0], [1, 0], [2, 0]]}})"), kShape + "/polygon", "lie on a line",
     kGeometry},
    {with_shape(R"({"polygon": {"vertices": [[0, 0], [1, 0], 2]}})"), kShape + "/polygon/vertices/2",
     "must be a vector [x, y], got 2"},
    {with_shape(R"({"segment": {"from": [1, 1], "to": [1, 1]}})"), kShape + "/segment", "are the same point, [1, 1]",
     kGeometry},
    {with_shape(R"({"chain": {"points": [[0, 0], [1, 0], [1, 0]]}})"), kShape + "/chain",
     "the points 1 and 2 of the chain are the same", kGeometry},
    {with_shape(R"({"chain": {"points": [[0, 0]]}})"), kShape + "/chain/points", "must be an array of at least 2"},
    {with_shape(R"({"outline": {"points": [[0, 0], [1, 1], [1, 0], [0, 1]]}})"), kShape + "/outline", "edge",
     kGeometry},
    {with_shape(R"({"circle": {"radius": 1}, "material": "ice"})"), kShape + "/material",
     "there is no material \"ice\"", kNames},
    // joints
    {with_joint(R"("bodies": ["a", "b"], "anchor": [0, 0])"), "/joints/0", "the key \"type\" is missing"},
    {with_joint(R"("type": "cog", "bodies": ["a", "b"], "anchor": [0, 0])"), "/joints/0/type",
     "must be one of revolute, distance"},
    {with_joint(R"("type": "revolute", "anchor": [0, 0])"), "/joints/0", "needs one of the keys bodies, joints"},
    {with_joint(R"("type": "revolute", "joints": ["c", "d"], "anchor": [0, 0])"), "/joints/0/joints",
     "belongs to gear joints", kKinds},
    {with_joint(R"("type": "gear", "bodies": ["a", "b"])"), "/joints/0/bodies", "belongs to revolute", kKinds},
    {with_joint(R"("type": "gear", "bodies": ["a", "b"], "joints": ["c", "d"])"), "/joints/0/joints",
     "only one of them is allowed"},
    {with_gear(R"("joints": ["c"])"), "/joints/2/joints", "must be an array of 2 names"},
    {with_gear(R"("joints": ["hinge", "hinges"])"), "/joints/2/joints/1", "there is no joint \"hinges\"", kNames},
    {with_gear(R"("joints": ["glue", "hinge"])"), "/joints/2/joints/0",
     "a gear connects revolute or prismatic joints; \"glue\" is neither", kNames},
    {with_gear(R"("name": "self", "joints": ["self", "hinge"])"), "/joints/2/joints/0", "\"self\" is neither", kNames},
    {with_gear(R"("joints": ["hinge", "hinge"])"), "/joints/2/joints", "a gear needs two joints", kNames},
    {with_gear(R"("joints": ["hinge", "rail"], "ratio": 0)"), "/joints/2/ratio", "must not be 0", kNumbers},
    {with_gear(R"("joints": ["hinge", "rail"], "anchor": [0, 0])"), "/joints/2/anchor", "belongs to revolute", kKinds},
    {with_gear(R"("joints": ["hinge", "rail"], "repeat": {"columns": 2})"), "/joints/2/repeat",
     "needs a joint that is a copy of a repeated joint", kNames},
    {with_joint(R"("type": "pulley", "bodies": ["a", "b"], "anchors": [[0, 0], [0, 0]])"), "/joints/0",
     "'ground_anchors' is missing", kNeeds},
    {with_joint(R"("type": "pulley", "bodies": ["a", "b"], "ground_anchors": [[0, 9], [2, 9]])"), "/joints/0",
     "'anchors' is missing", kNeeds},
    {with_joint(
         R"("type": "pulley", "bodies": ["a", "b"], "anchors": [[0, 0], [0, 0]], "ground_anchors": [[0, 9], [2, 9]], "ratio": -1)"),
     "/joints/0/ratio", "must be greater than 0", kNumbers},
    {with_joint(
         R"("type": "pulley", "bodies": ["a", "b"], "anchors": [[0, 0], [0, 0]], "ground_anchors": [[0, 0], [2, 0]])"),
     "/joints/0", "apart from its wheels", kGeometry},
    {with_joint(R"("type": "weld", "bodies": ["a", "b"], "anchor": [0, 0], "ratio": 2)"), "/joints/0/ratio",
     "belongs to pulley and gear joints", kKinds},
    {with_joint(R"("type": "revolute", "bodies": ["a"], "anchor": [0, 0])"), "/joints/0/bodies",
     "must be an array of 2 names"},
    {with_joint(R"("type": "revolute", "bodies": ["a", "c"], "anchor": [0, 0])"), "/joints/0/bodies/1",
     "there is no body \"c\"", kNames},
    {with_joint(R"("type": "revolute", "bodies": ["a", "a"], "anchor": [0, 0])"), "/joints/0/bodies",
     "a joint needs two bodies", kNames},
    {with_joint(R"("type": "revolute", "bodies": ["a", "b"])"), "/joints/0", "needs one of the keys anchor, anchors",
     kNeeds},
    {with_joint(R"("type": "revolute", "bodies": ["a", "b"], "anchor": [0, 0], "anchors": [[0, 0], [0, 0]])"),
     "/joints/0/anchors", "only one of them is allowed"},
    {with_joint(R"("type": "revolute", "bodies": ["a", "b"], "anchor": [0, 0], "repeat": {"columns": 2})"),
     "/joints/0/repeat", "needs a body that is a copy of a repeated body", kNames},
    {with_joint(R"("type": "distance", "bodies": ["a", "b"], "anchor": [0, 0])"), "/joints/0/anchor", "needs 'anchors'",
     kNeeds},
    {with_joint(R"("type": "distance", "bodies": ["a", "b"], "anchors": [[2, 0], [0, 0]])"), "/joints/0",
     "needs anchors that are apart", kGeometry},
    {with_joint(R"("type": "distance", "bodies": ["a", "b"], "anchors": [[0, 0], [0, 0]], "length": 0)"),
     "/joints/0/length", "must be greater than 0, got 0"},
    {with_joint(R"("type": "revolute", "bodies": ["a", "b"], "anchor": [0, 0], "limits": [20, -20])"),
     "/joints/0/limits", "lower <= upper", kNumbers},
    {with_joint(R"("type": "revolute", "bodies": ["a", "b"], "anchor": [0, 0], "length": 2)"), "/joints/0/length",
     "belongs to distance and pulley joints", kKinds},
    {with_joint(R"("type": "weld", "bodies": ["a", "b"], "anchor": [0, 0], "axis": [1, 0])"), "/joints/0/axis",
     "belongs to prismatic and wheel joints", kKinds},
    {with_joint(R"("type": "wheel", "bodies": ["a", "b"], "anchor": [0, 0])"), "/joints/0", "'axis' is missing",
     kNeeds},
    {with_joint(R"("type": "wheel", "bodies": ["a", "b"], "anchor": [0, 0], "axis": [0, 0])"), "/joints/0",
     "the axis of a joint", kGeometry},
    {with_joint(R"("type": "filter", "bodies": ["a", "b"], "anchor": [0, 0])"), "/joints/0/anchor",
     "belongs to revolute", kKinds},
    {with_joint(R"("type": "revolute", "bodies": ["a", "b"], "anchor": [0, 0], "motor": {"speed": 1, "max_force": 2})"),
     "/joints/0/motor", "'max_torque'", kNeeds},
    {with_joint(
         R"("type": "prismatic", "bodies": ["a", "b"], "anchor": [0, 0], "axis": [1, 0], "motor": {"speed": 1, "max_torque": 2})"),
     "/joints/0/motor", "'max_force'", kNeeds},
    {with_joint(R"("type": "revolute", "bodies": ["a", "b"], "anchor": [0, 0], "motor": {"speed": 1})"),
     "/joints/0/motor", "needs one of the keys max_torque, max_force"},
    // timeline, expectations, camera
    {R"({"format": 1, "timeline": [{"at": 1}]})", "/timeline/0",
     "needs one of the keys impulse, angular_impulse, force, torque, velocity, angular_velocity, motor_speed, target, "
     "gravity, spawn, despawn, release"},
    {R"({"format": 1, "timeline": [{"at": 1, "body": "x", "impulse": [1, 0]}]})", "/timeline/0/body",
     "there is no body \"x\"", kNames},
    {R"({"format": 1, "bodies": [{"name": "w", "type": "static"}], "timeline": [{"at": 1, "body": "w", "velocity": [1, 0]}]})",
     "/timeline/0/body", "\"w\" is static: its velocity cannot be set", kKinds},
    {R"({"format": 1, "bodies": [{"name": "w", "repeat": {"grid": {"columns": 2}}, "enabled": false}], "timeline": [{"at": 1, "body": "w[1]", "angular_velocity": 9}]})",
     "/timeline/0/body", "is disabled", kKinds},
    {R"({"format": 1, "timeline": [{"at": 1, "until": 2, "spawn": {}}]})", "/timeline/0/until",
     "belongs to events with 'every'", kKinds},
    {R"({"format": 1, "expect": [{"at_rest_by": 1, "max_penetration": 1}]})", "/expect/0/max_penetration",
     "only one of them is allowed"},
    {R"({"format": 1, "expect": [{"inside": [[0, 0], [1, 1]]}]})", "/expect/0", "the key \"body\" is missing", kNeeds},
    {R"({"format": 1, "camera": {"follow": "x"}})", "/camera/follow", "there is no body \"x\"", kNames},
    // more keys, counts and ends of ranges
    {R"({"format": null})", "/format", "must be 1, got null"},
    {R"("scene")", "", "must be an object, got \"scene\""},
    {R"({"format": 1, "world": {"steps_per_second": 0.5}})", "/world/steps_per_second", "must be at least 1, got 0.5"},
    {R"({"format": 1, "world": {"duration": -1}})", "/world/duration", "must be at least 0, got -1"},
    {R"({"format": 1, "world": {"scale": 0}})", "/world/scale", "must be at least 0.0001, got 0"},
    {R"({"format": 1, "world": {"gravity": 10}})", "/world/gravity", "must be a vector [x, y], got 10"},
    {R"({"format": 1, "camera": {"center": [0, 0, 0]}})", "/camera/center",
     "must be a vector [x, y], got an array of 3"},
    {R"({"format": 1, "camera": {"zoom": 2}})", "/camera/zoom", "unknown key \"zoom\""},
    {R"({"format": 1, "materials": []})", "/materials", "must be an object, got an empty array"},
    {R"({"format": 1, "materials": {"a": 1}})", "/materials/a", "must be an object, got 1"},
    {R"({"format": 1, "bodies": [1]})", "/bodies/0", "must be an object, got 1"},
    {R"({"format": 1, "bodies": [{"mass": 5}]})", "/bodies/0/mass", "must be an object, got 5"},
    {R"({"format": 1, "bodies": [{"mass": {"mass": 0, "inertia": 1}}]})", "/bodies/0/mass/mass",
     "must be greater than 0, got 0"},
    {R"({"format": 1, "bodies": [{"mass": {"mass": 1}}]})", "/bodies/0/mass", "the key \"inertia\" is missing"},
    {R"({"format": 1, "bodies": [{"shapes": {"circle": {"radius": 1}}}]})", "/bodies/0/shapes",
     "must be an array, got an object"},
    {R"({"format": 1, "bodies": [{"linear_damping": -0.1}]})", "/bodies/0/linear_damping",
     "must be at least 0, got -0.1"},
    {R"({"format": 1, "bodies": [{"friction": 1}]})", "/bodies/0/friction", "unknown key \"friction\""},
    {R"({"format": 1, "bodies": [{"gravity": [0, 0]}]})", "/bodies/0/gravity", "unknown key \"gravity\""},
    {R"({"format": 1, "bodies": [{"repeat": {"grid": {"columns": 0}}}]})", "/bodies/0/repeat/grid/columns",
     "must be at least 1, got 0"},
    {R"({"format": 1, "bodies": [{"repeat": {"ring": {}}}]})", "/bodies/0/repeat/ring", "the key \"count\" is missing"},
    {R"({"format": 1, "bodies": [{"repeat": 3}]})", "/bodies/0/repeat", "must be an object, got 3"},
    {with_shape("[]"), kShape, "must be an object, got an empty array"},
    {with_shape(R"({"circle": 1})"), kShape + "/circle", "must be an object, got 1"},
    {with_shape(R"({"circle": {"radius": "1"}})"), kShape + "/circle/radius", "must be a number, got \"1\""},
    {with_shape(R"({"box": {"size": 1}})"), kShape + "/box/size", "must be a vector [x, y], got 1"},
    {with_shape(R"({"capsule": {"from": [0, 0], "radius": 1}})"), kShape + "/capsule", "the key \"to\" is missing"},
    {with_shape(R"({"polygon": {"vertices": 3}})"), kShape + "/polygon/vertices", "must be an array, got 3"},
    {with_shape(R"({"circle": {"radius": 1}, "sensor": "yes"})"), kShape + "/sensor", "must be true or false"},
    {with_shape(R"({"circle": {"radius": 1}, "filter": {"category": -1}})"), kShape + "/filter/category",
     "must be at least 0, got -1"},
    {with_shape(R"({"circle": {"radius": 1}, "filter": {"mask": 4294967296}})"), kShape + "/filter/mask",
     "must be at most 4294967295"},
    {with_joint(R"("type": "revolute", "bodies": "ab", "anchor": [0, 0])"), "/joints/0/bodies",
     "must be an array of 2 names, got \"ab\""},
    {with_joint(R"("type": "revolute", "bodies": ["a", "b"], "anchor": [0, 0], "spring": {"hertz": 0})"),
     "/joints/0/spring/hertz", "must be greater than 0, got 0"},
    {with_joint(R"("type": "revolute", "bodies": ["a", "b"], "anchor": [0, 0], "limits": 20)"), "/joints/0/limits",
     "must be [lower, upper], got 20"},
    {with_joint(R"("type": "revolute", "bodies": ["a", "b"], "anchor": [0, 0], "break_force": 0)"),
     "/joints/0/break_force", "must be greater than 0, got 0"},
    {with_joint(R"("type": "distance", "bodies": ["a", "b"], "anchors": [[0, 0], [0, 0]], "limits": [-1, 2])"),
     "/joints/0/limits", "the limits of a distance must not be negative", kKinds},
    {with_joint(R"("type": "mouse", "bodies": ["a", "b"], "anchor": [0, 0], "max_torque": 2)"), "/joints/0/max_torque",
     "belongs to motor joints", kKinds},
    {R"({"format": 1, "timeline": {}})", "/timeline", "must be an array, got an object"},
    {R"({"format": 1, "timeline": [{"gravity": [0, 0]}]})", "/timeline/0", "needs one of the keys at, every"},
    {R"({"format": 1, "timeline": [{"at": 1, "every": 1, "gravity": [0, 0]}]})", "/timeline/0/every",
     "only one of them is allowed"},
    {R"({"format": 1, "timeline": [{"every": 0, "gravity": [0, 0]}]})", "/timeline/0/every",
     "must be greater than 0, got 0"},
    {R"({"format": 1, "timeline": [{"every": 0.001, "gravity": [0, 0]}]})", "/timeline/0/every",
     "is shorter than a step", kNumbers},
    {R"({"format": 1, "timeline": [{"at": 2, "impulse": [0, 0]}]})", "/timeline/0", "the key \"body\" is missing",
     kNeeds},
    {R"({"format": 1, "bodies": [{"name": "a"}], "timeline": [{"at": 2, "until": 1, "body": "a", "force": [0, 0]}]})",
     "/timeline/0/until", "must be after 'at'", kNumbers},
    {R"({"format": 1, "bodies": [{"name": "a"}], "timeline": [{"at": 2, "spawn": {"name": "a"}}]})",
     "/timeline/0/spawn/name", "is already the name of a body that exists", kNames},
    {R"({"format": 1, "timeline": [{"at": 2, "spawn": {"shapes": [{"circle": {"radius": -1}}]}}]})",
     "/timeline/0/spawn/shapes/0/circle/radius", "must be greater than 0, got -1"},
    {R"({"format": 1, "timeline": [{"at": 2, "from": 1, "gravity": [0, 0]}]})", "/timeline/0/from",
     "belongs to events with 'every'", kKinds},
    {R"({"format": 1, "timeline": [{"every": 1, "from": 2, "until": 1, "gravity": [0, 0]}]})", "/timeline/0/until",
     "must not be before 'from'", kNumbers},
    {R"({"format": 1, "bodies": [{"name": "a", "repeat": {"ring": {"count": 2}}}], "timeline": [{"at": 1, "spawn": {"name": "a[1]"}}]})",
     "/timeline/0/spawn/name", "exists from the start", kNames},
    {R"({"format": 1, "timeline": [{"every": 1, "spawn": {"name": "a"}}, {"at": 1, "spawn": {"name": "a[7]"}}]})",
     "/timeline/1/spawn/name", "reserved for a copy that the timeline spawns", kNames},
    {R"({"format": 1, "timeline": [{"every": 1, "spawn": {"name": "a"}}, {"every": 2, "spawn": {"name": "a"}}]})",
     "/timeline/1/spawn/name", "already the name of the body that /timeline/0 spawns", kNames},
    {R"({"format": 1, "timeline": [{"at": 1, "spawn": {"repeat": {"grid": {"columns": 1000000, "rows": 1000000}}}}]})",
     "/timeline/0/spawn/repeat", "1000000000000", kNumbers},
    {R"({"format": 1, "timeline": [{"at": 3, "spawn": {"name": "a"}}, {"at": 1, "spawn": {"name": "a"}}, {"at": 4, "despawn": "a"}]})",
     "/timeline/1/spawn/name", "already the name of the body that /timeline/0 spawns", kNames},
    {R"({"format": 1, "timeline": [{"at": 2, "release": "x"}]})", "/timeline/0/release", "there is no joint \"x\"",
     kNames},
    {R"({"format": 1, "expect": [{}]})", "/expect/0", "needs one of the keys at_rest_by"},
    {R"({"format": 1, "expect": [{"at_rest_by": "soon"}]})", "/expect/0/at_rest_by", "must be a number, got \"soon\""},
    {R"({"format": 1, "expect": [{"count": [2, 1], "region": [[0, 0], [1, 1]]}]})", "/expect/0/count", "lower <= upper",
     kNumbers},
    {R"({"format": 1, "expect": [{"count": [1, 2]}]})", "/expect/0", "'region' is missing", kNeeds},
    {R"({"format": 1, "expect": [{"event_count": [1, 2], "event": "bang"}]})", "/expect/0/event",
     "must be one of contact_begin"},
    {R"({"format": 1, "expect": [{"count": [1, 2], "region": [[1, 1], [0, 0]]}]})", "/expect/0/region",
     "the lower left and the upper right corner", kNumbers},
    {R"({"format": 1, "expect": [{"state_hash": "xyz"}]})", "/expect/0/state_hash", "must be 16 digits"},
    {with_claim(R"("picture": "golden.jpg")"), "/expect/0/picture", "must be the name of a .png file"},
    {R"({"format": 1, "expect": [{"at_rest_by": 1, "frame": {"angle": 3}}]})", "/expect/0/frame",
     "belongs to claims on positions", kKinds},
    {R"({"format": 1, "expect": [{"at_rest_by": 1, "when": "never"}]})", "/expect/0/when",
     "must be one of end, always, sometime"},
    // includes
    {R"({"format": 1, "include": {"file": "a.json"}})", "/include", "must be an array, got an object"},
    {R"({"format": 1, "include": ["a.json"]})", "/include/0", "must be an object, got \"a.json\""},
    {R"({"format": 1, "include": [{"position": [0, 0]}]})", "/include/0", "the key \"file\" is missing"},
    {R"({"format": 1, "include": [{"file": ""}]})", "/include/0/file", "must be a name of 1 to 256 bytes"},
    {R"({"format": 1, "include": [{"file": "a.json", "angle": "10"}]})", "/include/0/angle",
     "must be a number, got \"10\""},
    {R"({"format": 1, "include": [{"file": "no/such.json"}]})", "/include/0/file",
     "only scenes that are read from files", kFiles},
    {R"({"format": 1, "include": [{"file": "a.json"}, {"file": "b.json"}]})", "/include/0/file",
     "only scenes that are read from files", kFiles},
    {R"({"format": 1, "bodies": [{"name": ")" + std::string(257, 'n') + R"("}]})", "/bodies/0/name",
     "must be a name of 1 to 256 bytes", kForm},
    // conditions
    {with_claim(R"("that": "a.x >")"), "/expect/0/that", "expected a value, got the end", kForm},
    {with_claim(R"("that": "c.x > 1")"), "/expect/0/that", "there is no body or joint 'c'", kNames},
    {with_claim(R"("that": "a.x")"), "/expect/0/that", "must be a condition, and this is a number", kForm},
    {with_claim(R"("that": "")"), "/expect/0/that", "must be an expression of 1 to 2000 bytes"},
    {with_claim(R"("that": 5)"), "/expect/0/that", "must be a string, got 5"},
    {with_claim(R"("that": "true", "body": "a")"), "/expect/0/body", "belongs to claims on a body", kKinds},
    {with_claim(R"("that": "true", "before": "a.y")"), "/expect/0/before", "must be a condition", kForm},
    {with_claim(R"("that": "true", "before": "true", "when": "always")"), "/expect/0/when",
     "belongs to claims on a state", kKinds},
    {with_claim(R"("at_rest_by": 1, "before": "true")"), "/expect/0/before", "belongs to 'that'", kKinds},
    {with_claim(R"("max_time_ratio": 2)"), "/expect/0", "the key 'reference' is missing", kNeeds},
    {with_claim(R"("at_rest_by": 1, "reference": "a.json")"), "/expect/0/reference", "belongs to 'max_time_ratio'",
     kKinds},
    {with_claim(R"("at_rest_by": 1, "tolerance": 1)"), "/expect/0/tolerance", "belongs to 'picture'", kKinds},
    {with_event(R"("when": "a.x > 'b", "despawn": "a")"), "/timeline/0/when", "the quote ' is not closed", kForm},
    {with_event(R"("when": "true", "at": 1, "despawn": "a")"), "/timeline/0/when", "only one of them is allowed"},
    {with_event(R"("when": "true", "until": 1, "despawn": "a")"), "/timeline/0/until", "belongs to events with 'every'",
     kKinds},
    {with_event(R"("at": 1, "delay": 1, "despawn": "a")"), "/timeline/0/delay", "belongs to events with 'when'",
     kKinds},
    {with_event(R"("at": 1, "frame": {}, "despawn": "a")"), "/timeline/0/frame", "belongs to events with 'when'",
     kKinds},
    {with_event(R"("at": 1, "stop": false)"), "/timeline/0/stop", "must be true, got false", kNumbers},
    {with_event(R"("every": 1, "stop": true)"), "/timeline/0/every", "a run ends once", kKinds},
};

}  // namespace tumble::test
