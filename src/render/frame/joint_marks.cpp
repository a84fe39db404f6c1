#include "render/frame/joint_marks.hpp"

#include <algorithm>
#include <optional>
#include <variant>
#include <vector>

#include "render/frame/joint_paths.hpp"
#include "render/shapes/shape_primitives.hpp"
#include "render/style/style.hpp"

namespace tumble::render {
namespace {

constexpr double kAnchorMetres = 0.12;   // largest radius of a dot in the world
constexpr double kWheelMetres = 0.25;    // largest radius of a pulley's wheel in the world
constexpr double kCoilMetres = 0.14;     // largest half width of a spring in the world
constexpr double kSmallestAnchor = 0.8;  // least radius of a dot that is drawn (pixels)

void add_anchor(Layer& layer, const View& view, DVec2 at, const Colors& colors) {
    const double radius = std::min(style::kAnchor * view.detail(), kAnchorMetres * view.scale);
    if (radius < kSmallestAnchor || !view.is_in_view(at, radius)) return;
    layer.circles.push_back({static_cast<float>(at.x),
                             static_cast<float>(at.y),
                             static_cast<float>(radius),
                             {colors.anchor, colors.joint}});
}

// The end of a gear's line at one of its joints. A prismatic joint is a rail: the point on its axis nearest to the
// wheel. A hinge is an axle: its own anchor.
DVec2 meshing_point(const World& world, JointId joint, DVec2 own, DVec2 wheel) {
    const auto* rail = std::get_if<PrismaticJointDef>(&world.joint(joint));
    if (!rail) return own;
    const DVec2 axis = rotate(world.state(rail->body_a).pose.rotation, DVec2(rail->axis_a));
    return own + (dot(axis, wheel - own) / length_sq(axis)) * axis;
}

// The points that a joint is drawn through, but for pulleys, springs and ropes: its anchors. A gear runs from axle to
// axle or rail.
std::vector<DVec2> path_of(const World& world, JointId id) {
    const std::optional<JointAnchors> ends = world.joint_anchors(id);
    if (!ends) return {};
    if (const auto* gear = std::get_if<GearJointDef>(&world.joint(id)))
        return {meshing_point(world, gear->joint_a, ends->a, ends->b),
                meshing_point(world, gear->joint_b, ends->b, ends->a)};
    return {ends->a, ends->b};
}

void add_path(Layer& layer, const View& view, const std::vector<DVec2>& path, double width, Color color) {
    for (std::size_t i = 1; i < path.size(); ++i)
        if (length(path[i] - path[i - 1]) > 0.0)
            add_line(layer, view, path[i - 1], path[i], width * view.detail(), color);
}

// Draws the joint as a spring, a rope or a pulley if it is one.
bool add_device(Layer& layer, const View& view, const World& world, JointId id, const Colors& colors) {
    const std::optional<JointAnchors> ends = world.joint_anchors(id);
    if (!ends) return false;
    const DVec2 a = view.to_pixels(ends->a), b = view.to_pixels(ends->b);
    const DVec2 down = DVec2(world.def().gravity);
    if (const auto* pulley = std::get_if<PulleyJointDef>(&world.joint(id))) {
        const PulleyPath rope =
            pulley_path(a, view.to_pixels(pulley->ground_anchor_a), view.to_pixels(pulley->ground_anchor_b), b,
                        kWheelMetres * view.scale, down);
        add_path(layer, view, rope.points, style::kRope, colors.rope);
        for (const DVec2 wheel : {rope.wheel_a, rope.wheel_b}) {
            if (rope.radius < kSmallestAnchor || !view.is_in_view(wheel, rope.radius)) continue;
            layer.circles.push_back({static_cast<float>(wheel.x),
                                     static_cast<float>(wheel.y),
                                     static_cast<float>(rope.radius),
                                     {colors.kinematic_fill, colors.joint}});
            add_anchor(layer, view, wheel, colors);
        }
    } else if (const auto* rod = std::get_if<DistanceJointDef>(&world.joint(id)); rod && rod->spring) {
        add_path(layer, view, coil_path(a, b, rod->length * view.scale, kCoilMetres * view.scale), style::kMark,
                 colors.joint);
    } else if (rod && rod->limits && rod->limits->lower < rod->limits->upper && !rod->motor) {
        add_path(layer, view, rope_path(a, b, rod->limits->upper * view.scale, down), style::kRope, colors.rope);
    } else {
        return false;
    }
    add_anchor(layer, view, a, colors);
    add_anchor(layer, view, b, colors);
    return true;
}

}  // namespace

void add_joints(Layer& layer, const View& view, const World& world, std::span<const JointId> joints,
                const Colors& colors) {
    for (const JointId joint : joints) {
        if (!world.is_valid(joint) || add_device(layer, view, world, joint, colors)) continue;
        std::optional<DVec2> from;
        for (const DVec2 point : path_of(world, joint)) {
            const DVec2 to = view.to_pixels(point);
            if (from && length(to - *from) > 2.0 * style::kAnchor * view.detail())
                add_line(layer, view, *from, to, style::kMark * view.detail(), colors.joint);
            if (!from || length(to - *from) > 1.0) add_anchor(layer, view, to, colors);
            from = to;
        }
    }
}

}  // namespace tumble::render
