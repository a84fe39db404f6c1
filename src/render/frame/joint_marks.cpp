#include "render/frame/joint_marks.hpp"

#include <algorithm>
#include <optional>
#include <variant>
#include <vector>

#include "render/shapes/shape_primitives.hpp"
#include "render/style/style.hpp"

namespace tumble::render {
namespace {

constexpr double kAnchorMetres = 0.12;   // largest radius of a dot in the world
constexpr double kSmallestAnchor = 0.8;  // least radius of a dot that is drawn (pixels)

void add_anchor(Layer& layer, const View& view, DVec2 at) {
    const double radius = std::min(style::kAnchor * view.detail(), kAnchorMetres * view.scale);
    if (radius < kSmallestAnchor || !view.is_in_view(at, radius)) return;
    layer.circles.push_back({static_cast<float>(at.x),
                             static_cast<float>(at.y),
                             static_cast<float>(radius),
                             {style::kAnchorFill, style::kJoint}});
}

// The end of a gear's line at one of its joints. A prismatic joint is a rail: the point on its axis nearest to the
// wheel. A hinge is an axle: its own anchor.
DVec2 meshing_point(const World& world, JointId joint, DVec2 own, DVec2 wheel) {
    const auto* rail = std::get_if<PrismaticJointDef>(&world.joint(joint));
    if (!rail) return own;
    const DVec2 axis = rotate(world.state(rail->body_a).pose.rotation, DVec2(rail->axis_a));
    return own + (dot(axis, wheel - own) / length_sq(axis)) * axis;
}

// The points that a joint is drawn through: its anchors, with the wheels of a pulley between them. A gear runs from
// axle to axle or rail.
std::vector<DVec2> path_of(const World& world, JointId id) {
    const std::optional<JointAnchors> ends = world.joint_anchors(id);
    if (!ends) return {};
    if (const auto* pulley = std::get_if<PulleyJointDef>(&world.joint(id)))
        return {ends->a, pulley->ground_anchor_a, pulley->ground_anchor_b, ends->b};
    if (const auto* gear = std::get_if<GearJointDef>(&world.joint(id)))
        return {meshing_point(world, gear->joint_a, ends->a, ends->b),
                meshing_point(world, gear->joint_b, ends->b, ends->a)};
    return {ends->a, ends->b};
}

}  // namespace

void add_joints(Layer& layer, const View& view, const World& world, std::span<const JointId> joints) {
    for (const JointId joint : joints) {
        if (!world.is_valid(joint)) continue;
        std::optional<DVec2> from;
        for (const DVec2 point : path_of(world, joint)) {
            const DVec2 to = view.to_pixels(point);
            if (from && length(to - *from) > 2.0 * style::kAnchor * view.detail())
                add_line(layer, view, *from, to, style::kMark * view.detail(), style::kJoint);
            if (!from || length(to - *from) > 1.0) add_anchor(layer, view, to);
            from = to;
        }
    }
}

}  // namespace tumble::render
