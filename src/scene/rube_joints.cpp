// Radians become degrees; limits, motors and springs are kept where the scene has a place for them.
#include "scene/rube_joints.hpp"

#include <algorithm>
#include <array>

#include "scene/json_text.hpp"

namespace tumble::scene {

namespace {

constexpr double kLeastLength = 0.005;  // m; Box2D lengthens shorter distance joints to this
constexpr std::array<std::string_view, 11> kTypes = {"revolute", "distance", "prismatic", "wheel", "weld", "motor",
                                                     "rope",     "friction", "pulley",    "mouse", "gear"};

void read_revolute(RubeObject& joint, SceneJoint& result) {
    result.type = SceneJointType::revolute;
    result.reference_angle = joint.number("refAngle") * kDegrees;
    const SceneInterval limits{joint.number("lowerLimit") * kDegrees, joint.number("upperLimit") * kDegrees};
    if (joint.flag("enableLimit"))
        result.limits = {std::min(limits.lower, limits.upper), std::max(limits.lower, limits.upper)};
    const SceneJointMotor motor{joint.number("motorSpeed") * kDegrees, joint.number("maxMotorTorque"), {}};
    if (joint.flag("enableMotor")) result.motor = motor;
    joint.skip({"jointSpeed"});  // of the moment of the export
}

void read_distance(RubeObject& joint, SceneJoint& result) {
    result.type = SceneJointType::distance;
    result.length = std::max(joint.number("length"), kLeastLength);
    const SceneJointSpring spring{joint.number("frequency"), joint.number("dampingRatio")};
    if (spring.hertz > 0.0) result.spring = spring;
}

}  // namespace

std::optional<SceneJoint> read_rube_joint(RubeObject joint, std::size_t body_count,
                                          const std::function<std::string(std::size_t)>& name_of, RubeNotes& notes) {
    const std::string type = joint.text("type");
    const int a = joint.index("bodyA", body_count), b = joint.index("bodyB", body_count);
    if (a < 0 || b < 0) return std::nullopt;
    if (type != "revolute" && type != "distance") {
        const bool known = std::find(kTypes.begin(), kTypes.end(), type) != kTypes.end();
        notes.add(known ? type + " joints, left out" : "joints of the unknown type " + quoted(type) + ", left out");
        return std::nullopt;
    }
    if (a == b) {
        notes.add("joints of a body with itself, left out");
        return std::nullopt;
    }
    SceneJoint result;
    result.name = joint.text("name");
    result.body_a = name_of(static_cast<std::size_t>(a));
    result.body_b = name_of(static_cast<std::size_t>(b));
    result.anchors = {joint.vector("anchorA"), joint.vector("anchorB")};
    result.collide_connected = joint.flag("collideConnected");
    if (type == "revolute") read_revolute(joint, result);
    if (type == "distance") read_distance(joint, result);
    const std::string properties = joint.raw("customProperties");
    if (!properties.empty()) result.custom = "{\"customProperties\": " + properties + "}";
    joint.note_unread(type + " joint", notes);
    return result;
}

}  // namespace tumble::scene
