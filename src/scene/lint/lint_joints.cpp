// Lints of joints before the first step.
#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <variant>

#include "scene/json/problem_codes.hpp"
#include "scene/lint/lint.hpp"
#include "scene/lint/measures.hpp"
#include "scene/model/degrees.hpp"
#include "scene/model/display.hpp"
#include "scene/model/joint_gap.hpp"
#include "tumble/distance.hpp"
#include "tumble/world_def.hpp"

namespace tumble::scene {

namespace {

constexpr double kOneLength = 0.01;  // of the longest: copies whose lengths differ by less are spokes of one hub
constexpr double kWideAngle = 5.0;   // degrees: a joint that starts less out of its range turns gently
constexpr double kFarAnchor = 10.0;  // times the size of a body: a longer lever arm is taken for an error

class JointLinter {
public:
    JointLinter(const Scene& scene, const SceneWorld& built, Diagnostics& diagnostics)
        : scene_(scene), world_(built.world), built_(built), diagnostics_(diagnostics) {}

    void lint(const SceneJointInstance& joint) {
        const SceneJointType type = scene_.joints[joint.source].type;
        if (type == SceneJointType::filter || type == SceneJointType::gear)
            return;  // the joints of a gear are linted by themselves
        const auto [a, b] =
            std::visit([](const auto& def) { return std::pair(def.body_a, def.body_b); }, world_.joint(joint.id));
        if (reported_.contains(joint.source)) return;
        lint_masses(joint, a, b);
        if (!lint_gap(joint, a, b)) lint_anchors(joint, a, b);
        lint_angle(joint);
        if (reported_springs_.insert(joint.source).second) {
            const SceneJoint& source = scene_.joints[joint.source];
            lint_units(source, pointer(joint));
            lint_spring(source.spring, pointer(joint) + "/spring");
            lint_spring(source.angular_spring, pointer(joint) + "/angular_spring");
        }
    }

private:
    static std::string pointer(const SceneJointInstance& joint) { return "/joints/" + std::to_string(joint.source); }

    void warn(std::string_view code, const SceneJointInstance& joint, const std::string& message,
              const std::string& hint) {
        diagnostics_.warning(code, pointer(joint), message, hint);
        reported_.insert(joint.source);
    }

    void lint_masses(const SceneJointInstance& joint, BodyId a, BodyId b) {
        if (world_.type(a) != BodyType::dynamic_body || world_.type(b) != BodyType::dynamic_body) return;
        if (mass_ratio(world_, a, b) <= kLargeMassRatio) return;
        warn(codes::joint_mass_ratio, joint,
             "the joint connects bodies of " + brief(world_.mass(a).mass) + " kg and " + brief(world_.mass(b).mass) +
                 " kg: a joint stretches if one body is over 100 times heavier than the other",
             "bring their densities closer together, or give the world more substeps");
    }

    bool lint_gap(const SceneJointInstance& joint, BodyId a, BodyId b) {
        const double gap = joint_gap(world_, joint.id);
        const double size = smaller_size(largest_extent(world_, a), largest_extent(world_, b));
        if (!(gap > kWideGap * size)) return false;
        warn(codes::open_joint, joint,
             "the joint starts " + brief(gap) + " m away from a position that it allows for " +
                 display_name(built_, a) + " and " + display_name(built_, b) + ": it will pull them there at once",
             R"(correct its anchors, its "length" or its "limits", or move the bodies)");
        return true;
    }

    // The angle of a hinge, which is no part of its gap.
    void lint_angle(const SceneJointInstance& joint) {
        const JointDef def = world_.joint(joint.id);
        const auto* const hinge = std::get_if<RevoluteJointDef>(&def);
        if (hinge == nullptr || !hinge->limits) return;
        const double angle = world_.joint_motion(joint.id).position * kDegrees;
        const double lower = hinge->limits->lower * kDegrees, upper = hinge->limits->upper * kDegrees;
        if (angle > lower - kWideAngle && angle < upper + kWideAngle) return;
        warn(codes::outside_limits, joint,
             "the joint starts at " + brief(angle) + " degrees, outside of its limits: it will turn the bodies at once",
             R"(its angle is 0 at load unless a "reference_angle" is stated: shift the "limits", or turn the bodies)");
    }

    void lint_units(const SceneJoint& joint, const std::string& pointer) {
        if (joint.reference_angle) lint_degrees(*joint.reference_angle, pointer + "/reference_angle", diagnostics_);
        if (joint.type != SceneJointType::revolute || !joint.limits) return;
        lint_degrees(joint.limits->lower, pointer + "/limits/0", diagnostics_);
        lint_degrees(joint.limits->upper, pointer + "/limits/1", diagnostics_);
    }

    void lint_anchors(const SceneJointInstance& joint, BodyId a, BodyId b) {
        const std::optional<JointAnchors> anchors = world_.joint_anchors(joint.id);
        if (!anchors || !is_far(a, anchors->a) || !is_far(b, anchors->b)) return;
        warn(codes::far_anchor, joint,
             "the joint acts at " + brief(anchors->a) + ", far from both " + display_name(built_, a) + " and " +
                 display_name(built_, b) + ": its lever arm is over 10 times their size",
             R"("anchor" is a point of the world, "anchors" are points in the coordinates of each body)");
    }

    // No point is far from a body without shapes: its size is unknown.
    bool is_far(BodyId body, DVec2 point) const {
        const Shape at_point = make_circle(0.0f);
        const double far = kFarAnchor * largest_extent(world_, body);
        return far > 0.0 && std::ranges::all_of(world_.shapes(body), [&](ShapeId shape) {
                   return distance(world_.shape(shape), world_.state(body).pose, at_point, {point, {}}).distance > far;
               });
    }

    void lint_spring(const std::optional<SceneJointSpring>& spring, const std::string& pointer) {
        const double stiffest = double{world_limits(world_.def()).stiffest_spring};
        if (!spring || !(spring->hertz > stiffest)) return;
        diagnostics_.warning(
            codes::stiff_spring, pointer + "/hertz",
            "the spring is stiffer than the steps can follow: it is limited to " + brief(stiffest) + " Hz",
            "use more substeps or steps_per_second, or a softer spring");
    }

    const Scene& scene_;
    const World& world_;
    const SceneWorld& built_;
    Diagnostics& diagnostics_;
    std::set<std::size_t> reported_, reported_springs_;  // joints of the scene
};

// The copies of one rod whose anchors on one body are all the same point.
struct RodCopies {
    std::set<BodyId> bodies_a, bodies_b;
    double shortest = std::numeric_limits<double>::infinity(), longest = 0.0;  // m

    void add(const World& world, JointId id) {
        const std::optional<JointAnchors> anchors = world.joint_anchors(id);
        if (!anchors) return;
        std::visit([this](const auto& def) { bodies_a.insert(def.body_a), bodies_b.insert(def.body_b); },
                   world.joint(id));
        shortest = std::min(shortest, length(anchors->b - anchors->a));
        longest = std::max(longest, length(anchors->b - anchors->a));
    }

    // The body that all copies join at one point, though they are not the spokes of a hub.
    std::optional<BodyId> shared_body() const {
        if ((bodies_a.size() == 1) == (bodies_b.size() == 1) || longest - shortest <= kOneLength * longest)
            return std::nullopt;
        return bodies_a.size() == 1 ? *bodies_a.begin() : *bodies_b.begin();
    }
};

void lint_rods(const Scene& scene, const SceneWorld& built, Diagnostics& diagnostics) {
    std::map<std::size_t, RodCopies> rods;  // by the joint of the scene
    for (const SceneJointInstance& joint : built.joints)
        if (scene.joints[joint.source].repeat && scene.joints[joint.source].type == SceneJointType::distance)
            rods[joint.source].add(built.world, joint.id);
    for (const auto& [source, copies] : rods)
        if (const std::optional<BodyId> body = copies.shared_body())
            diagnostics.warning(codes::joined_copies, "/joints/" + std::to_string(source) + "/repeat",
                                "all copies of the joint act at one point of " + display_name(built, *body) +
                                    ", which is not repeated: they are from " + brief(copies.shortest) + " to " +
                                    brief(copies.longest) + " m long",
                                "give \"repeat\" a \"spacing\": it moves the anchor on that body from one copy to the "
                                "next; or repeat the body too");
}

}  // namespace

void add_joint_lints(const Scene& scene, const SceneWorld& built, Diagnostics& diagnostics) {
    JointLinter linter(scene, built, diagnostics);
    for (const SceneJointInstance& joint : built.joints) linter.lint(joint);
    lint_rods(scene, built, diagnostics);
}

}  // namespace tumble::scene
