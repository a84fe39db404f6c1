#include "reference/b2_rube.hpp"

#include <box2d/box2d.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "tumble/file.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::reference {

namespace {

using Json = nlohmann::json;

// A number, or the bit pattern of one as 8 hexadecimal digits.
float to_number(const Json& value) {
    if (value.is_string()) return std::bit_cast<float>(static_cast<std::uint32_t>(std::stoul(value.get<std::string>(), nullptr, 16)));
    return value.is_number() ? value.get<float>() : 0.0f;
}

float number(const Json& object, const char* key, float missing = 0.0f) {
    return object.contains(key) ? to_number(object[key]) : missing;
}

b2Vec2 vector(const Json& object, const char* key) {
    if (!object.contains(key) || !object[key].is_object()) return {0.0f, 0.0f};
    return {number(object[key], "x"), number(object[key], "y")};
}

// From the first brace to the last: a JavaScript file has more around the scene.
Json parse_export(const std::filesystem::path& file) {
    const std::string text = read_file(file, std::numeric_limits<std::size_t>::max() - 1);
    const std::size_t open = text.find('{'), close = text.rfind('}');
    if (open == std::string::npos || close == std::string::npos || close < open)
        throw std::runtime_error(file.string() + ": is no R.U.B.E. export");
    return Json::parse(text.begin() + static_cast<std::ptrdiff_t>(open), text.begin() + static_cast<std::ptrdiff_t>(close) + 1);
}

// Its mass data replaces that of its fixtures, which are not needed then.
b2Body* add_body(b2World& world, const Json& json) {
    b2BodyDef def;
    def.type = static_cast<b2BodyType>(json.value("type", 0));
    def.position = vector(json, "position");
    def.angle = number(json, "angle");
    def.fixedRotation = json.value("fixedRotation", false);
    b2Body* body = world.CreateBody(&def);
    b2MassData mass;
    mass.mass = number(json, "massData-mass");
    mass.center = vector(json, "massData-center");
    mass.I = number(json, "massData-I");
    body->SetMassData(&mass);
    return body;
}

// Where a joint holds its two bodies, by Box2D's joints; nothing for joints without two points of their own.
std::optional<JointAnchors> anchors_of(const Json& json, b2Body& a, b2Body& b, b2World& world) {
    const std::string type = json.value("type", "");
    b2RevoluteJointDef def;  // every kind keeps its local anchors as this one does
    def.bodyA = &a;
    def.bodyB = &b;
    def.localAnchorA = vector(json, "anchorA");
    def.localAnchorB = vector(json, "anchorB");
    constexpr std::array<std::string_view, 7> kKinds = {"revolute", "distance", "prismatic", "wheel", "weld", "rope", "friction"};
    if (std::ranges::find(kKinds, type) == kKinds.end()) return std::nullopt;
    const b2Joint* joint = world.CreateJoint(&def);
    const b2Vec2 at_a = joint->GetAnchorA(), at_b = joint->GetAnchorB();
    return JointAnchors{{double{at_a.x}, double{at_a.y}}, {double{at_b.x}, double{at_b.y}}};
}

double relative(double ours, double theirs) {
    const double apart = std::abs(ours - theirs);
    return apart > 0.0 ? apart / std::abs(theirs) : 0.0;
}

void compare_bodies(const b2Body& theirs, const BodyMass& ours, ImportDifferences& worst) {
    const double mass = double{theirs.GetMass()}, inertia = double{theirs.GetInertia()};  // about the origin
    const b2Vec2 center = theirs.GetLocalCenter();
    const DVec2 our_center(ours.center);
    worst.mass = std::max(worst.mass, relative(double{ours.mass}, mass));
    worst.inertia = std::max(worst.inertia, relative(double{ours.inertia} + double{ours.mass} * length_sq(our_center), inertia));
    const double apart = length(our_center - DVec2{double{center.x}, double{center.y}});
    if (apart > 0.0) worst.center = std::max(worst.center, apart / std::sqrt(inertia / mass));
    ++worst.bodies;
}

bool is_carried_over(const Json& joint) {
    constexpr std::array<std::string_view, 9> kKinds = {"revolute", "distance", "prismatic", "wheel", "weld",
                                                        "motor",    "rope",     "friction",  "mouse"};
    return std::ranges::find(kKinds, joint.value("type", "")) != kKinds.end() && joint.value("bodyA", 0) != joint.value("bodyB", 0);
}

}  // namespace

ImportDifferences compare_with_box2d(const std::filesystem::path& rube_file, const Scene& imported) {
    const Json document = parse_export(rube_file);
    const SceneWorld built = build_world(imported);
    b2World world({0.0f, 0.0f});
    ImportDifferences worst;
    std::vector<b2Body*> bodies;
    for (const Json& body : document.value("body", Json::array())) bodies.push_back(add_body(world, body));
    worst.same_count = bodies.size() == built.bodies.size();
    for (std::size_t i = 0; i < std::min(bodies.size(), built.bodies.size()); ++i) {
        const BodyId id = built.bodies[i].id;
        if (built.world.type(id) == BodyType::dynamic_body && built.world.is_enabled(id))
            compare_bodies(*bodies[i], built.world.mass(id), worst);
    }
    std::size_t next = 0;
    for (const Json& joint : document.value("joint", Json::array())) {
        if (!is_carried_over(joint)) continue;
        if (next >= built.joints.size()) {
            ++next;
            continue;
        }
        const std::optional<JointAnchors> theirs =
            anchors_of(joint, *bodies.at(joint.value("bodyA", std::size_t{0})), *bodies.at(joint.value("bodyB", std::size_t{0})), world);
        const std::optional<JointAnchors> ours = built.world.joint_anchors(built.joints[next++].id);
        if (!theirs || !ours) continue;
        worst.anchor = std::max({worst.anchor, length(ours->a - theirs->a), length(ours->b - theirs->b)});
        ++worst.joints;
    }
    worst.same_count = worst.same_count && next == built.joints.size();
    return worst;
}

}  // namespace tumble::reference
