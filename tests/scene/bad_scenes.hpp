// Scenes that the reader must reject, with the place and a part of the message of the first error.
#pragma once

#include <string>
#include <vector>

namespace tumble::test {

struct BadScene {
    std::string text;
    std::string pointer;
    std::string message;
    bool schema_knows = true;  // a JSON schema can express the rule
};

// One body with one shape.
inline std::string with_shape(const std::string& shape) {
    return R"({"format": 1, "bodies": [{"shapes": [)" + shape + "]}]}";
}

// Two bodies and a joint.
inline std::string with_joint(const std::string& keys) {
    return R"({"format": 1, "bodies": [{"name": "a"}, {"name": "b", "position": [2, 0]}], "joints": [{)" + keys + "}]}";
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
    {R"({"format": 1, "name": "a", "name": "b"})", "/name", "this key occurs twice", false},
    // numbers
    {R"({"format": 1, "world": {"gravity": [0]}})", "/world/gravity", "must be a vector [x, y], got an array of 1"},
    {R"({"format": 1, "world": {"gravity": [0, "1"]}})", "/world/gravity/1", "must be a number, got \"1\""},
    {R"({"format": 1, "world": {"gravity": [0, 1e300]}})", "/world/gravity/1", "must be at most 1000000, got 1e+300"},
    {R"({"format": 1, "world": {"substeps": 0}})", "/world/substeps", "must be at least 1, got 0"},
    {R"({"format": 1, "world": {"substeps": 2.5}})", "/world/substeps", "must be a whole number, got 2.5"},
    {R"({"format": 1, "world": {"seed": -1}})", "/world/seed", "must be at least 0, got -1"},
    {R"({"format": 1, "world": {"seed": 18446744073709551616}})", "/world/seed", "must be at most", false},
    {R"({"format": 1, "world": {"sleeping": 1}})", "/world/sleeping", "must be true or false, got 1"},
    {R"({"format": 1, "camera": {"height": 0}})", "/camera/height", "must be greater than 0, got 0"},
    {R"({"format": 1, "materials": {"a": {"restitution": 1.5}}})", "/materials/a/restitution", "must be at most 1, got 1.5"},
    {R"({"format": 1, "materials": {"a": {"color": "red"}}})", "/materials/a/color", "must be a colour"},
    {R"({"format": 1, "materials": {"a/b": {"density": -1}}})", "/materials/a~1b/density", "must be at least 0, got -1"},
    // bodies
    {R"({"format": 1, "bodies": [{"type": "rigid"}]})", "/bodies/0/type", "must be one of static, kinematic, dynamic"},
    {R"({"format": 1, "bodies": [{"name": ""}]})", "/bodies/0/name", "must be a name of 1 to 256 bytes"},
    {R"({"format": 1, "bodies": [{"name": "a"}, {"name": "a"}]})", "/bodies/1/name", "is the name of /bodies/0 already", false},
    {R"({"format": 1, "bodies": [{"name": "a", "repeat": {"ring": {"count": 2}}}, {"name": "a[1]"}]})", "/bodies/1/name", "is the name of a copy", false},
    {R"({"format": 1, "bodies": [{"repeat": {}}]})", "/bodies/0/repeat", "needs one of the keys grid, pyramid, ring, scatter"},
    {R"({"format": 1, "bodies": [{"repeat": {"ring": {"count": 2}, "grid": {}}}]})", "/bodies/0/repeat/ring", "only one of them is allowed"},
    {R"({"format": 1, "bodies": [{"repeat": {"pyramid": {"base": 0}}}]})", "/bodies/0/repeat/pyramid/base", "must be at least 1, got 0"},
    {R"({"format": 1, "bodies": [{"repeat": {"grid": {"columns": 1000000, "rows": 1000000}}}]})", "/bodies/0", "makes 1000000000000 bodies", false},
    {R"({"format": 1, "bodies": [{"repeat": {"scatter": {"count": 50, "size": [1, 1], "separation": 1}}}]})", "/bodies/0/repeat", "found room for", false},
    // shapes
    {with_shape("{}"), kShape, "needs one of the keys circle, capsule, box, polygon, segment, chain, outline"},
    {with_shape(R"({"circle": {"radius": 1}, "box": {"size": [1, 1]}})"), kShape + "/box", "only one of them is allowed"},
    {with_shape(R"({"circle": {}})"), kShape + "/circle", "the key \"radius\" is missing"},
    {with_shape(R"({"circle": {"radius": -1}})"), kShape + "/circle/radius", "must be greater than 0, got -1"},
    {with_shape(R"({"circle": {"radius": 0}})"), kShape + "/circle/radius", "must be greater than 0, got 0"},
    {with_shape(R"({"circle": {"radius": 1e-60}})"), kShape + "/circle", "the radius 1e-60 is too small", false},
    {with_shape(R"({"box": {"size": [0, 1]}})"), kShape + "/box/size/0", "must be greater than 0, got 0"},
    {with_shape(R"({"box": {"size": [1, 1], "radius": 0.6}})"), kShape + "/box", "more than half the smaller side", false},
    {with_shape(R"({"polygon": {"vertices": [[0, 0], [1, 0]]}})"), kShape + "/polygon/vertices", "must be an array of at least 3, got an array of 2"},
    {with_shape(R"({"polygon": {"vertices": [[0, 0], [1, 0], [2, 0]]}})"), kShape + "/polygon", "lie on a line", false},
    {with_shape(R"({"polygon": {"vertices": [[0, 0], [1, 0], 2]}})"), kShape + "/polygon/vertices/2", "must be a vector [x, y], got 2"},
    {with_shape(R"({"segment": {"from": [1, 1], "to": [1, 1]}})"), kShape + "/segment", "are the same point, [1, 1]", false},
    {with_shape(R"({"chain": {"points": [[0, 0], [1, 0], [1, 0]]}})"), kShape + "/chain", "the points 1 and 2 of the chain are the same", false},
    {with_shape(R"({"chain": {"points": [[0, 0]]}})"), kShape + "/chain/points", "must be an array of at least 2"},
    {with_shape(R"({"outline": {"points": [[0, 0], [1, 1], [1, 0], [0, 1]]}})"), kShape + "/outline", "edge", false},
    {with_shape(R"({"circle": {"radius": 1}, "material": "ice"})"), kShape + "/material", "there is no material \"ice\"", false},
    // joints
    {with_joint(R"("bodies": ["a", "b"], "anchor": [0, 0])"), "/joints/0", "the key \"type\" is missing"},
    {with_joint(R"("type": "gear", "bodies": ["a", "b"], "anchor": [0, 0])"), "/joints/0/type", "must be one of revolute, distance"},
    {with_joint(R"("type": "revolute", "bodies": ["a"], "anchor": [0, 0])"), "/joints/0/bodies", "must be an array of 2 names"},
    {with_joint(R"("type": "revolute", "bodies": ["a", "c"], "anchor": [0, 0])"), "/joints/0/bodies/1", "there is no body \"c\"", false},
    {with_joint(R"("type": "revolute", "bodies": ["a", "a"], "anchor": [0, 0])"), "/joints/0/bodies", "a joint needs two bodies", false},
    {with_joint(R"("type": "revolute", "bodies": ["a", "b"])"), "/joints/0", "needs one of the keys anchor, anchors", false},
    {with_joint(R"("type": "revolute", "bodies": ["a", "b"], "anchor": [0, 0], "anchors": [[0, 0], [0, 0]])"), "/joints/0/anchors", "only one of them is allowed"},
    {with_joint(R"("type": "distance", "bodies": ["a", "b"], "anchor": [0, 0])"), "/joints/0/anchor", "needs 'anchors'", false},
    {with_joint(R"("type": "distance", "bodies": ["a", "b"], "anchors": [[2, 0], [0, 0]])"), "/joints/0", "needs anchors that are apart", false},
    {with_joint(R"("type": "distance", "bodies": ["a", "b"], "anchors": [[0, 0], [0, 0]], "length": 0)"), "/joints/0/length", "must be greater than 0, got 0"},
    {with_joint(R"("type": "revolute", "bodies": ["a", "b"], "anchor": [0, 0], "limits": [20, -20])"), "/joints/0/limits", "lower <= upper", false},
    {with_joint(R"("type": "revolute", "bodies": ["a", "b"], "anchor": [0, 0], "length": 2)"), "/joints/0/length", "belongs to distance joints", false},
    {with_joint(R"("type": "weld", "bodies": ["a", "b"], "anchor": [0, 0], "axis": [1, 0])"), "/joints/0/axis", "belongs to prismatic and wheel joints", false},
    {with_joint(R"("type": "wheel", "bodies": ["a", "b"], "anchor": [0, 0])"), "/joints/0", "'axis' is missing", false},
    {with_joint(R"("type": "wheel", "bodies": ["a", "b"], "anchor": [0, 0], "axis": [0, 0])"), "/joints/0", "the axis of a joint", false},
    {with_joint(R"("type": "filter", "bodies": ["a", "b"], "anchor": [0, 0])"), "/joints/0/anchor", "belongs to revolute", false},
    {with_joint(R"("type": "revolute", "bodies": ["a", "b"], "anchor": [0, 0], "motor": {"speed": 1, "max_force": 2})"), "/joints/0/motor", "'max_torque'", false},
    {with_joint(R"("type": "prismatic", "bodies": ["a", "b"], "anchor": [0, 0], "axis": [1, 0], "motor": {"speed": 1, "max_torque": 2})"), "/joints/0/motor", "'max_force'", false},
    {with_joint(R"("type": "revolute", "bodies": ["a", "b"], "anchor": [0, 0], "motor": {"speed": 1})"), "/joints/0/motor", "needs one of the keys max_torque, max_force"},
    // timeline, expectations, camera
    {R"({"format": 1, "timeline": [{"at": 1}]})", "/timeline/0", "needs one of the keys impulse, angular_impulse, force, torque, velocity, angular_velocity, motor_speed, target, gravity, spawn, despawn, release"},
    {R"({"format": 1, "timeline": [{"at": 1, "body": "x", "impulse": [1, 0]}]})", "/timeline/0/body", "there is no body \"x\"", false},
    {R"({"format": 1, "timeline": [{"at": 1, "until": 2, "spawn": {}}]})", "/timeline/0/until", "belongs to events with 'every'", false},
    {R"({"format": 1, "expect": [{"at_rest_by": 1, "max_penetration": 1}]})", "/expect/0/max_penetration", "only one of them is allowed"},
    {R"({"format": 1, "expect": [{"inside": [[0, 0], [1, 1]]}]})", "/expect/0", "the key \"body\" is missing", false},
    {R"({"format": 1, "camera": {"follow": "x"}})", "/camera/follow", "there is no body \"x\"", false},
};

}  // namespace tumble::test
