#include "render/labels/drawn_shapes.hpp"

#include <algorithm>
#include <optional>

#include "render/shapes/shape_primitives.hpp"
#include "render/style/style.hpp"

namespace tumble::render {
namespace {

constexpr int kKinds = 5;

// The place of the only primitive of a layer among its kinds; nothing for an empty layer.
std::optional<int> kind_in(const Layer& layer) {
    if (!layer.mesh.empty()) return 0;
    if (!layer.polygons.empty()) return 1;
    if (!layer.rounded_polygons.empty()) return 2;
    if (!layer.boxes.empty()) return 3;
    if (!layer.circles.empty()) return 4;
    return std::nullopt;
}

}  // namespace

double line_width(const View& view) { return style::kSegment * view.detail(); }

void DrawnShapes::add(const World& world, const View& view, BodyId body, std::size_t label,
                      std::span<const Paint> paints) {
    if (label > kMostLabels) return;
    const std::span<const ShapeId> shapes = world.shapes(body);
    const Pose pose = world.state(body).pose;
    parts_.clear();
    solid_.clear();
    for (std::size_t k = 0; k < shapes.size(); ++k) {
        if (world.is_sensor(shapes[k])) continue;
        parts_.push_back({&world.shape(shapes[k]), paints.empty() ? Paint{} : paints[k]});
        solid_.push_back(shapes[k]);
    }
    find_joined(parts_);
    const int layer_rank = world.type(body) == BodyType::static_body ? 0 : kKinds;
    for (std::size_t k = 0; k < parts_.size(); ++k) {
        layer_.clear();
        add_shape(layer_, view, *parts_[k].shape, pose, parts_[k].paint, line_width(view));
        const std::optional<int> kind = kind_in(layer_);
        if (!kind) continue;
        const int kind_rank = parts_[k].is_joined ? 0 : *kind;
        shapes_.push_back({static_cast<BodyLabel>(label), body, solid_[k], layer_rank + kind_rank});
    }
}

std::span<const DrawnShape> DrawnShapes::sorted() {
    std::ranges::stable_sort(shapes_, {}, &DrawnShape::rank);
    return shapes_;
}

}  // namespace tumble::render
