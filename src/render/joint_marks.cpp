#include "render/joint_marks.hpp"

#include <algorithm>
#include <optional>

#include "render/shape_primitives.hpp"
#include "render/style.hpp"

namespace tumble::render {
namespace {

constexpr double kAnchorMetres = 0.12;   // dots shrink with the scene once they would be larger than this
constexpr double kSmallestAnchor = 0.8;  // pixels; smaller ones are left out

void add_anchor(Layer& layer, const View& view, DVec2 at) {
    const double radius = std::min(style::kAnchor * view.detail(), kAnchorMetres * view.scale);
    if (radius < kSmallestAnchor || !view.sees(at, radius)) return;
    layer.circles.push_back({static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(radius),
                             {style::kAnchorFill, style::kJoint}});
}

}  // namespace

void add_joints(Layer& layer, const View& view, const World& world, std::span<const SceneJointInstance> joints) {
    for (const SceneJointInstance& joint : joints) {
        if (!world.is_valid(joint.id)) continue;
        const std::optional<JointAnchors> ends = world.joint_anchors(joint.id);
        if (!ends) continue;
        const DVec2 from = view.to_pixels(ends->a), to = view.to_pixels(ends->b);
        if (length(to - from) > 2.0 * style::kAnchor * view.detail())
            add_line(layer, view, from, to, style::kMark * view.detail(), style::kJoint);
        add_anchor(layer, view, from);
        if (length(to - from) > 1.0) add_anchor(layer, view, to);
    }
}

}  // namespace tumble::render
