#include "render/shapes/orientation_mark.hpp"

#include <algorithm>
#include <limits>

#include "debug/check.hpp"
#include "render/shapes/shape_primitives.hpp"
#include "render/style/style.hpp"

namespace tumble::render {
namespace {

constexpr double kTick = 0.45;  // length of a tick, as a share of half the shape's smaller extent

Vec2 middle(const Shape& shape) {
    Vec2 sum;
    for (int i = 0; i < shape.vertex_count(); ++i) sum += shape.vertex(i);
    return (1.0f / static_cast<float>(shape.vertex_count())) * sum;
}

// The distance (m) from a point inside a shape of two or more vertices to its edge in direction +x.
float distance_to_edge(const Shape& shape, Vec2 from) {
    const int count = shape.vertex_count();
    TUMBLE_CHECK(count >= 2);
    if (count == 2) return std::max(shape.vertex(0).x, shape.vertex(1).x) - from.x + shape.radius();
    float least = std::numeric_limits<float>::infinity();
    for (int i = 0; i < count; ++i) {
        const Vec2 vertex = shape.vertex(i);
        const Vec2 edge = shape.vertex(i + 1 < count ? i + 1 : 0) - vertex;
        if (edge.y <= 0.0f) continue;  // its outward normal (edge.y, -edge.x) does not face +x
        least = std::min(least, cross(vertex - from, edge) / edge.y);
    }
    return least + shape.radius();
}

}  // namespace

void add_orientation_mark(Layer& layer, const View& view, const Shape& shape, const Pose& pose, Color color) {
    const int count = shape.vertex_count();
    if (count == 0) return;
    const float smaller_half = 0.5f * extent(shape).smaller;
    if (view.scale * smaller_half < style::kSmallestMark) return;
    const Vec2 center = middle(shape);
    const DVec2 center_pixels = view.to_pixels(transform_point(pose, center));
    if (!view.is_in_view(center_pixels, view.scale * extent(shape).larger)) return;

    const double edge = count == 1 ? shape.radius() : distance_to_edge(shape, center);
    const double tick = count == 1 ? edge : std::min(kTick * smaller_half, edge);
    // Both ends stay clear of the outline by the mark's own width.
    const double outer = std::max(edge - style::kMark * view.detail() / view.scale, edge - tick);
    const Vec2 from{center.x + static_cast<float>(edge - tick), center.y};
    const Vec2 to{center.x + static_cast<float>(outer), center.y};
    add_line(layer, view, view.to_pixels(transform_point(pose, from)), view.to_pixels(transform_point(pose, to)),
             style::kMark * view.detail(), color);
}

}  // namespace tumble::render
