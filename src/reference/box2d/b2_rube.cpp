#include "reference/box2d/b2_rube.hpp"

#include <box2d/box2d.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "tumble/file.hpp"
#include "tumble/scene_import.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::reference {

namespace {

using Json = nlohmann::json;

// A number, or the bit pattern of one as 8 hexadecimal digits.
float to_number(const Json& value) {
    if (value.is_string())
        return std::bit_cast<float>(static_cast<std::uint32_t>(std::stoul(value.get<std::string>(), nullptr, 16)));
    return value.is_number() ? value.get<float>() : 0.0f;
}

float number(const Json& object, const char* key, float missing = 0.0f) {
    return object.contains(key) ? to_number(object[key]) : missing;
}

// Indices may be written as any number, as the importer accepts them.
std::size_t index(const Json& object, const char* key) { return static_cast<std::size_t>(number(object, key)); }

b2Vec2 vector(const Json& object, const char* key) {
    if (!object.contains(key) || !object[key].is_object()) return {0.0f, 0.0f};
    return {number(object[key], "x"), number(object[key], "y")};
}

// With comments, as the importer accepts them.
Json parse_export(const std::filesystem::path& file) {
    return Json::parse(rube_json(read_file(file)), nullptr, true, true);
}

// The angle of a body within half a turn, in double as the importer computes it: Box2D's float has no turn left of an
// angle of millions of radians.
float turn_of(const Json& body) {
    const bool is_number = body.contains("angle") && body["angle"].is_number();
    const double angle = is_number ? body["angle"].get<double>() : double{number(body, "angle")};
    return static_cast<float>(std::remainder(angle, 2.0 * kPi));
}

// Whether Box2D accepts the mass data of a body that may rotate: the inertia about the centre of mass must be positive,
// in its own arithmetic.
bool is_accepted(const b2MassData& data) {
    const float mass = data.mass > 0.0f ? data.mass : 1.0f;
    return !(data.I > 0.0f) || data.I - mass * b2Dot(data.center, data.center) > 0.0f;
}

struct BodyPair {
    b2Body* theirs = nullptr;
    bool refused_inertia = false;
};

// Makes a body with the exported mass data, which replaces the mass of fixtures: none are built.
BodyPair add_body(b2World& world, const Json& json) {
    b2BodyDef def;
    def.type = static_cast<b2BodyType>(static_cast<int>(number(json, "type")));
    def.position = vector(json, "position");
    def.angle = turn_of(json);
    def.fixedRotation = json.value("fixedRotation", false);
    b2Body* body = world.CreateBody(&def);
    b2MassData mass;
    mass.mass = number(json, "massData-mass");
    mass.center = vector(json, "massData-center");
    mass.I = number(json, "massData-I");
    const bool is_refused = def.type == b2_dynamicBody && !def.fixedRotation && !is_accepted(mass);
    if (is_refused) mass.I = 0.0f;
    body->SetMassData(&mass);
    return {body, is_refused};
}

// Makes a revolute joint in place of any joint with two anchors: all kinds of Box2D keep their anchors alike. Null for
// the other kinds.
b2Joint* add_joint(const Json& json, b2Body& a, b2Body& b, b2World& world) {
    constexpr std::array<std::string_view, 8> kKinds = {"revolute", "distance", "prismatic", "wheel",
                                                        "weld",     "rope",     "friction",  "pulley"};
    if (std::ranges::find(kKinds, json.value("type", "")) == kKinds.end()) return nullptr;
    b2RevoluteJointDef def;
    def.bodyA = &a;
    def.bodyB = &b;
    def.localAnchorA = vector(json, "anchorA");
    def.localAnchorB = vector(json, "anchorB");
    return world.CreateJoint(&def);
}

// Null for a gear between a body and itself, or on a body that is not dynamic, which Box2D lacks.
b2Joint* add_gear(b2Joint* first, b2Joint* second, b2World& world) {
    if (first->GetBodyB() == second->GetBodyB()) return nullptr;
    for (b2Joint* joint : {first, second})
        if (joint->GetBodyB()->GetType() != b2_dynamicBody) return nullptr;
    b2GearJointDef def;
    def.bodyA = first->GetBodyB();
    def.bodyB = second->GetBodyB();
    def.joint1 = first;
    def.joint2 = second;
    return world.CreateJoint(&def);
}

// Whether the importer has added a static body, the last one, for the images of the world.
bool has_backdrop(const Json& document, const Scene& imported) {
    const auto is_of_world = [](const Json& image) { return number(image, "body", -1.0f) < 0.0f; };
    return std::ranges::any_of(document.value("image", Json::array()), is_of_world) && !imported.bodies.empty() &&
           imported.bodies.back().shapes.empty() && imported.bodies.back().type == BodyType::static_body;
}

constexpr double kNear = 100.0;  // m: up to here the rounding of Box2D's float coordinates counts as a difference

double relative(double ours, double theirs) {
    const double apart = std::abs(ours - theirs);
    return apart > 0.0 ? apart / std::abs(theirs) : 0.0;
}

void widen(ImportDifference& worst, double found, const std::string& owner) {
    if (found > worst.value) worst = {found, owner};
}

void compare_bodies(const BodyPair& pair, const BodyMass& ours, const std::string& name, ImportDifferences& worst) {
    const b2Body& theirs = *pair.theirs;
    const double mass = double{theirs.GetMass()};
    const b2Vec2 center = theirs.GetLocalCenter();
    const DVec2 our_center(ours.center);
    const double our_inertia = double{ours.inertia} + double{ours.mass} * length_sq(our_center);  // about the origin
    const double inertia = double{theirs.GetInertia()};
    widen(worst.mass, relative(double{ours.mass}, mass), name);
    if (pair.refused_inertia)
        ++worst.refused_inertias;
    else if (!theirs.IsFixedRotation())
        widen(worst.inertia, relative(our_inertia, inertia), name);
    // Box2D has no inertia of a body with fixed rotation.
    const double gyration = std::sqrt(std::max(inertia / mass, our_inertia / double{ours.mass}));
    const double apart = length(our_center - DVec2{double{center.x}, double{center.y}});
    if (apart > 0.0) widen(worst.center, apart / gyration, name);
    ++worst.bodies;
}

void compare_joint(b2Joint& theirs, const World& world, JointId ours, const std::string& name,
                   ImportDifferences& worst) {
    const std::optional<JointAnchors> anchors = world.joint_anchors(ours);
    if (!anchors) return;
    // Box2D's world coordinates are float: a pose and an arm, rounded and added.
    constexpr double kRounding = 4.0 * double{std::numeric_limits<float>::epsilon()};
    const auto apart = [](DVec2 at, b2Vec2 other) {
        const double found = length(at - DVec2{double{other.x}, double{other.y}});
        return std::max(0.0, found - kRounding * std::max(length(at) - kNear, 0.0));
    };
    widen(worst.anchor, std::max(apart(anchors->a, theirs.GetAnchorA()), apart(anchors->b, theirs.GetAnchorB())), name);
    ++worst.joints;
}

bool is_gear(const Json& joint) { return joint.value("type", "") == "gear"; }

bool is_carried_over(const Json& joint) {
    constexpr std::array<std::string_view, 10> kKinds = {"revolute", "distance", "prismatic", "wheel", "weld",
                                                         "motor",    "rope",     "friction",  "mouse", "pulley"};
    const std::string type = joint.value("type", "");
    if (type == "pulley" && !(number(joint, "ratio") > 0.0f)) return false;
    return std::ranges::find(kKinds, type) != kKinds.end() && index(joint, "bodyA") != index(joint, "bodyB");
}

bool is_carried_over(const Json& gear, const Json& joints) {
    const auto can_be_geared = [&](const char* key) {
        const Json& joint = joints.at(index(gear, key));
        const std::string type = joint.value("type", "");
        return (type == "revolute" || type == "prismatic") && is_carried_over(joint);
    };
    return can_be_geared("joint1") && can_be_geared("joint2") && index(gear, "joint1") != index(gear, "joint2") &&
           number(gear, "ratio") != 0.0f;
}

}  // namespace

ImportDifferences compare_with_box2d(const std::filesystem::path& rube_file, const Scene& imported) {
    const Json document = parse_export(rube_file);
    const SceneWorld built = build_world(imported);
    b2World world({0.0f, 0.0f});
    ImportDifferences worst;
    std::vector<BodyPair> bodies;
    for (const Json& body : document.value("body", Json::array())) bodies.push_back(add_body(world, body));
    const std::size_t backdrops = has_backdrop(document, imported) ? 1 : 0;
    worst.same_count = bodies.size() + backdrops == built.bodies.size();
    for (std::size_t i = 0; i < std::min(bodies.size(), built.bodies.size()); ++i) {
        const BodyId id = built.bodies[i].id;
        if (built.world.type(id) == BodyType::dynamic_body && built.world.is_enabled(id))
            compare_bodies(bodies[i], built.world.mass(id), output_name(built.bodies[i], i), worst);
    }
    std::size_t next = 0;
    const auto compare_next = [&](b2Joint* theirs) {
        if (theirs && next < built.joints.size())
            compare_joint(*theirs, built.world, built.joints[next].id, output_name(built.joints[next], next), worst);
        ++next;
    };
    const Json joints = document.value("joint", Json::array());
    std::vector<b2Joint*> their_joints;
    for (const Json& joint : joints) {
        their_joints.push_back(nullptr);
        if (!is_carried_over(joint)) continue;
        their_joints.back() =
            add_joint(joint, *bodies.at(index(joint, "bodyA")).theirs, *bodies.at(index(joint, "bodyB")).theirs, world);
        compare_next(their_joints.back());
    }
    for (const Json& joint : joints)
        if (is_gear(joint) && is_carried_over(joint, joints))
            compare_next(add_gear(their_joints[index(joint, "joint1")], their_joints[index(joint, "joint2")], world));
    worst.same_count = worst.same_count && next == built.joints.size();
    return worst;
}

}  // namespace tumble::reference
