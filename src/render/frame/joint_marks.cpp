#include "render/frame/joint_marks.hpp"

#include <algorithm>
#include <optional>
#include <variant>
#include <vector>

#include "render/shapes/shape_primitives.hpp"
#include "render/style/style.hpp"

namespace tumble::render {
namespace {

constexpr double kAnchorMetres = 0.12;   // dots shrink with the scene once they would be larger than this
constexpr double kSmallestAnchor = 0.8;  // pixels; smaller ones are left out

void add_anchor(Layer& layer, const View& view, DVec2 at) {
    const double radius = std::min(style::kAnchor * view.detail(), kAnchorMetres * view.scale);
    if (radius < kSmallestAnchor || !view.sees(at, radius)) return;
    layer.circles.push_back({static_cast<float>(at.x),
                             static_cast<float>(at.y),
                             static_cast<float>(radius),
                             {style::kAnchorFill, style::kJoint}});
}

// Where a wheel meets the rail of a rack: nearest to the wheel on the line along which the rack slides. A hinge stays.
DVec2 meshing_point(const World& world, JointId joint, DVec2 own, DVec2 wheel) {
    const auto* rail = std::get_if<PrismaticJointDef>(&world.joint(joint));
    if (!rail) return own;
    const DVec2 axis = rotate(world.state(rail->body_a).pose.rotation, DVec2(rail->axis_a));
    return own + (dot(axis, wheel - own) / length_sq(axis)) * axis;
}

// What a joint is drawn along: the points that it acts on, and between them the wheels that a rope runs over. A gear is
// drawn from axle to axle, or to the rail.
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

void add_joints(Layer& layer, const View& view, const World& world, std::span<const SceneJointInstance> joints) {
    for (const SceneJointInstance& joint : joints) {
        if (!world.is_valid(joint.id)) continue;
        std::optional<DVec2> from;
        for (const DVec2 point : path_of(world, joint.id)) {
            const DVec2 to = view.to_pixels(point);
            if (from && length(to - *from) > 2.0 * style::kAnchor * view.detail())
                add_line(layer, view, *from, to, style::kMark * view.detail(), style::kJoint);
            if (!from || length(to - *from) > 1.0) add_anchor(layer, view, to);
            from = to;
        }
    }
}

}  // namespace tumble::render
