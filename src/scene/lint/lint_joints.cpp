// What joints show before the first step.
#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <variant>

#include "scene/lint/lint.hpp"
#include "scene/lint/measures.hpp"
#include "scene/model/display.hpp"
#include "scene/model/joint_gap.hpp"
#include "tumble/distance.hpp"
#include "tumble/world_limits.hpp"

namespace tumble::scene {

namespace {

constexpr double kWideGap = 0.1;     // of the size of the smaller body
constexpr double kFarAnchor = 10.0;  // times the size of a body: no lever is that long

class JointLinter {
public:
    JointLinter(const Scene& scene, const SceneWorld& built, Diagnostics& diagnostics)
        : scene_(scene), world_(built.world), built_(built), diagnostics_(diagnostics) {}

    void check(const SceneJointInstance& joint) {
        const SceneJointType type = scene_.joints[joint.source].type;
        if (type == SceneJointType::filter || type == SceneJointType::gear)
            return;  // a gear's joints are looked at themselves
        const auto [a, b] =
            std::visit([](const auto& def) { return std::pair(def.body_a, def.body_b); }, world_.joint(joint.id));
        if (said_.contains(joint.source)) return;
        check_masses(joint, a, b);
        if (!check_gap(joint, a, b)) check_anchors(joint, a, b);
        if (said_of_springs_.insert(joint.source).second) {
            const SceneJoint& source = scene_.joints[joint.source];
            check_spring(source.spring, pointer(joint) + "/spring");
            check_spring(source.angular_spring, pointer(joint) + "/angular_spring");
        }
    }

private:
    static std::string pointer(const SceneJointInstance& joint) { return "/joints/" + std::to_string(joint.source); }

    void warn(const SceneJointInstance& joint, const std::string& message, const std::string& hint) {
        diagnostics_.warning(pointer(joint), message, hint);
        said_.insert(joint.source);
    }

    void check_masses(const SceneJointInstance& joint, BodyId a, BodyId b) {
        if (world_.type(a) != BodyType::dynamic_body || world_.type(b) != BodyType::dynamic_body) return;
        if (mass_ratio(world_, a, b) <= kLargeMassRatio) return;
        warn(joint,
             "ties bodies of " + brief(world_.mass(a).mass) + " kg and " + brief(world_.mass(b).mass) +
                 " kg: joints stretch under what is over 100 times heavier",
             "bring the densities nearer to each other, or give the world more substeps");
    }

    // Of the largest shape (m); 0 without shapes.
    double size_of(BodyId body) const {
        double size = 0.0;
        for (const ShapeId shape : world_.shapes(body))
            size = std::max(size, double{extent(world_.shape(shape)).larger});
        return size;
    }

    bool check_gap(const SceneJointInstance& joint, BodyId a, BodyId b) {
        const double size_a = size_of(a), size_b = size_of(b), gap = joint_gap(world_, joint.id);
        const double size = size_a > 0.0 && size_b > 0.0 ? std::min(size_a, size_b) : std::max(size_a, size_b);
        if (!(gap > kWideGap * size)) return false;
        warn(joint,
             "starts " + brief(gap) + " m apart from where it holds " + display_name(built_, a) + " and " +
                 display_name(built_, b) + ": they are thrown together",
             R"(mend its anchors, its "length" or its "limits", or move the bodies)");
        return true;
    }

    void check_anchors(const SceneJointInstance& joint, BodyId a, BodyId b) {
        const std::optional<JointAnchors> anchors = world_.joint_anchors(joint.id);
        if (!anchors || !is_far(a, anchors->a) || !is_far(b, anchors->b)) return;
        warn(joint,
             "acts at " + brief(anchors->a) + ", far away from both " + display_name(built_, a) + " and " +
                 display_name(built_, b) + ": its lever is over ten times their size",
             R"("anchor" is a point of the world, "anchors" are points in the coordinates of each body)");
    }

    // Nothing is far from a body without shapes: it stands for a point.
    bool is_far(BodyId body, DVec2 point) const {
        const Shape at_point = make_circle(0.0f);
        const double far = kFarAnchor * size_of(body);
        return far > 0.0 && std::ranges::all_of(world_.shapes(body), [&](ShapeId shape) {
                   return distance(world_.shape(shape), world_.state(body).pose, at_point, {point, {}}).distance > far;
               });
    }

    void check_spring(const std::optional<SceneJointSpring>& spring, const std::string& pointer) {
        const double stiffest = double{world_limits(world_.def()).stiffest_spring};
        if (!spring || !(spring->hertz > stiffest)) return;
        diagnostics_.warning(pointer + "/hertz",
                             "is more than the steps can follow: it counts as " + brief(stiffest) + " Hz",
                             "more substeps or steps_per_second, or a softer spring");
    }

    const Scene& scene_;
    const World& world_;
    const SceneWorld& built_;
    Diagnostics& diagnostics_;
    std::set<std::size_t> said_, said_of_springs_;  // joints of the scene
};

}  // namespace

void add_joint_lints(const Scene& scene, const SceneWorld& built, Diagnostics& diagnostics) {
    JointLinter linter(scene, built, diagnostics);
    for (const SceneJointInstance& joint : built.joints) linter.check(joint);
}

}  // namespace tumble::scene
