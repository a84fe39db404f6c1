// Radians become degrees. Limits, motors and springs are kept if the scene format has them for the type of joint.
#include "import/rube/rube_joints.hpp"

#include <algorithm>
#include <array>

#include "scene/json/json_text.hpp"
#include "scene/model/degrees.hpp"

namespace tumble::scene {

namespace {

constexpr double kLeastLength = 0.005;  // m; Box2D lengthens shorter distance joints to this
constexpr std::array<std::string_view, 10> kTypes = {"revolute", "distance", "prismatic", "wheel", "weld",
                                                     "motor",    "rope",     "friction",  "mouse", "pulley"};

void read_revolute(RubeObject& joint, SceneJoint& result) {
    result.type = SceneJointType::revolute;
    result.reference_angle = joint.number("refAngle") * kDegrees;
    const SceneInterval limits{joint.number("lowerLimit") * kDegrees, joint.number("upperLimit") * kDegrees};
    if (joint.flag("enableLimit"))
        result.limits = {std::min(limits.lower, limits.upper), std::max(limits.lower, limits.upper)};
    const SceneJointMotor motor{joint.number("motorSpeed") * kDegrees, joint.number("maxMotorTorque"), {}};
    if (joint.flag("enableMotor")) result.motor = motor;
    joint.skip({"jointSpeed"});  // the speed at the moment of the export
}

void read_distance(RubeObject& joint, SceneJoint& result) {
    result.type = SceneJointType::distance;
    result.length = std::max(joint.number("length"), kLeastLength);
    const SceneJointSpring spring{joint.number("frequency"), joint.number("dampingRatio")};
    if (spring.hertz > 0.0) result.spring = spring;
}

void read_rope(RubeObject& joint, SceneJoint& result) {
    result.type = SceneJointType::distance;
    result.length = std::max(joint.number("maxLength"), kLeastLength);
    result.limits = {0.0, *result.length};
}

// The axis is in A's coordinates, as the anchors are. Old files use another key.
void read_axis(RubeObject& joint, SceneJoint& result, DVec2 missing) {
    const std::string_view key = joint.has("localAxisA") ? "localAxisA" : "localAxis1";
    const DVec2 axis = joint.has(key) ? joint.vector(key) : DVec2{};
    result.axis = axis == DVec2{} ? missing : axis;
}

void read_prismatic(RubeObject& joint, SceneJoint& result) {
    result.type = SceneJointType::prismatic;
    read_axis(joint, result, {1.0, 0.0});
    result.reference_angle = joint.number("refAngle") * kDegrees;
    const double lower = joint.number("lowerLimit"), upper = joint.number("upperLimit");
    if (joint.flag("enableLimit")) result.limits = {std::min(lower, upper), std::max(lower, upper)};
    const SceneJointMotor motor{joint.number("motorSpeed"), {}, joint.number("maxMotorForce")};
    if (joint.flag("enableMotor")) result.motor = motor;
    joint.skip({"jointSpeed"});
}

void read_wheel(RubeObject& joint, SceneJoint& result) {
    result.type = SceneJointType::wheel;
    read_axis(joint, result, {0.0, 1.0});
    const SceneJointMotor motor{joint.number("motorSpeed") * kDegrees, joint.number("maxMotorTorque"), {}};
    if (joint.flag("enableMotor")) result.motor = motor;
    const SceneJointSpring spring{joint.number("springFrequency"), joint.number("springDampingRatio")};
    if (spring.hertz > 0.0) result.spring = spring;
    joint.skip({"jointSpeed"});
}

void read_weld(RubeObject& joint, SceneJoint& result) {
    result.type = SceneJointType::weld;
    result.reference_angle = joint.number("refAngle") * kDegrees;
    const SceneJointSpring spring{joint.number("frequency"), joint.number("dampingRatio")};
    if (spring.hertz > 0.0) result.angular_spring = spring;
}

void read_friction(RubeObject& joint, SceneJoint& result) {
    result.type = SceneJointType::motor;
    result.max_force = joint.number("maxForce");
    result.max_torque = joint.number("maxTorque");
}

// A correction factor k removes the fraction k of the error in each step of 1/60 s. A critically damped spring of
// frequency 60 k / (2 pi) does about the same.
void read_motor(RubeObject& joint, SceneJoint& result) {
    read_friction(joint, result);
    if (joint.has("linearOffset")) result.anchors->first = joint.vector("linearOffset");
    result.anchors->second = {};
    result.reference_angle = joint.number("refAngle") * kDegrees;
    const double factor = joint.number("correctionFactor", 0.3);
    if (factor > 0.0) result.spring = SceneJointSpring{factor * 60.0 / (2.0 * kPi), 1.0};
    joint.skip({"anchorA", "anchorB"});
}

// The export's target is a world point; the first anchor of a mouse joint is a point of A.
void read_mouse(RubeObject& joint, SceneJoint& result, const Pose& world_from_a) {
    result.type = SceneJointType::mouse;
    const DVec2 target = joint.vector("target", kPosition);
    result.anchors->first = inverse_transform_point(world_from_a, target);
    result.max_force = joint.number("maxForce");
    const SceneJointSpring spring{joint.number("frequency", 5.0), joint.number("dampingRatio", 0.7)};
    if (spring.hertz > 0.0) result.spring = spring;
}

void read_pulley(RubeObject& joint, SceneJoint& result) {
    result.type = SceneJointType::pulley;
    result.ground_anchors = {joint.vector("groundAnchorA", kPosition), joint.vector("groundAnchorB", kPosition)};
    result.ratio = joint.number("ratio");
    result.length = std::max(joint.number("lengthA") + *result.ratio * joint.number("lengthB"), kLeastLength);
}

// "joint 'axle'", or the place of one without a name: "joint /joint/3".
std::string owner_of(RubeObject& joint) {
    const std::string name = joint.text("name");
    return "joint " + (name.empty() ? joint.pointer() : "'" + name + "'");
}

void read_common(RubeObject& joint, SceneJoint& result) {
    result.name = joint.text("name");
    result.collide_connected = joint.flag("collideConnected");
    result.custom = joint.custom({"customProperties"});
}

}  // namespace

std::optional<SceneJoint> read_rube_joint(RubeObject joint, const std::string& type, std::size_t body_count,
                                          const std::function<RubeBody(std::size_t)>& body_at, RubeNotes& notes) {
    const int a = joint.index("bodyA", body_count, "bodies"), b = joint.index("bodyB", body_count, "bodies");
    if (a < 0 || b < 0) return std::nullopt;
    if (std::ranges::find(kTypes, type) == kTypes.end()) {
        notes.add_of(owner_of(joint), "joints of the unknown type " + quoted(type) + ", left out");
        return std::nullopt;
    }
    if (a == b) {
        notes.add_of(owner_of(joint), "joints that connect a body to itself, left out");
        return std::nullopt;
    }
    if (type == "pulley" && !(joint.number("ratio") > 0.0)) {
        notes.add_of(owner_of(joint), "pulley joints whose ratio is not positive, left out");
        return std::nullopt;
    }
    SceneJoint result;
    read_common(joint, result);
    const RubeBody body_a = body_at(static_cast<std::size_t>(a));
    result.body_a = body_a.name;
    result.body_b = body_at(static_cast<std::size_t>(b)).name;
    result.anchors = {joint.vector("anchorA"), joint.vector("anchorB")};
    if (type == "revolute") read_revolute(joint, result);
    if (type == "distance") read_distance(joint, result);
    if (type == "rope") read_rope(joint, result);
    if (type == "prismatic") read_prismatic(joint, result);
    if (type == "wheel") read_wheel(joint, result);
    if (type == "weld") read_weld(joint, result);
    if (type == "friction") read_friction(joint, result);
    if (type == "motor") read_motor(joint, result);
    if (type == "mouse") read_mouse(joint, result, body_a.pose);
    if (type == "pulley") read_pulley(joint, result);
    joint.note_unread(type + " joint", notes);
    return result;
}

std::optional<SceneJoint> read_rube_gear(RubeObject joint, std::size_t joint_count,
                                         const std::function<SceneJoint*(std::size_t)>& joint_at, RubeNotes& notes) {
    const int a = joint.index("joint1", joint_count, "joints"), b = joint.index("joint2", joint_count, "joints");
    if (a < 0 || b < 0) return std::nullopt;
    const auto can_be_geared = [](const SceneJoint* geared) {
        return geared && (geared->type == SceneJointType::revolute || geared->type == SceneJointType::prismatic);
    };
    SceneJoint result;
    result.type = SceneJointType::gear;
    read_common(joint, result);
    result.ratio = joint.number("ratio");
    const SceneJoint *first = joint_at(static_cast<std::size_t>(a)), *second = joint_at(static_cast<std::size_t>(b));
    if (a == b || !can_be_geared(first) || !can_be_geared(second)) {
        notes.add_of(owner_of(joint), "gear joints that do not couple two revolute or prismatic joints, left out");
        return std::nullopt;
    }
    if (*result.ratio == 0.0) {
        notes.add_of(owner_of(joint), "gear joints of ratio 0, left out");
        return std::nullopt;
    }
    result.joint_a = first->name;
    result.joint_b = second->name;
    joint.skip({"type", "bodyA", "bodyB", "anchorA", "anchorB"});  // of the joints that it couples
    joint.note_unread("gear joint", notes);
    return result;
}

}  // namespace tumble::scene
