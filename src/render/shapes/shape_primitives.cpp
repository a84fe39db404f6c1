#include "render/shapes/shape_primitives.hpp"

#include <algorithm>
#include <limits>

#include "debug/check.hpp"
#include "render/shapes/outline_mesh.hpp"
#include "render/view/clip.hpp"

namespace tumble::render {
namespace {

// Larger shapes (pixels) are clipped in double first: float coordinates would be off by a hundredth of a pixel.
constexpr double kLargestInstance = 1e5;

float to_float(double value) { return static_cast<float>(value); }

// The center of an instance in pixels and the direction of its first side.
struct Placement {
    DVec2 center;
    Vec2 axis;
};

Placement place(const View& view, const Pose& pose, Vec2 local_center, Vec2 local_axis) {
    return {view.to_pixels(transform_point(pose, local_center)), rotate(pose.rotation, local_axis)};
}

void add_circle(Layer& layer, const View& view, const Shape& shape, const Pose& pose, Paint paint) {
    const DVec2 center = view.to_pixels(transform_point(pose, shape.vertex(0)));
    const double radius = view.scale * shape.radius();
    if (!view.is_in_view(center, radius)) return;
    layer.circles.push_back({to_float(center.x), to_float(center.y), to_float(radius), paint});
}

// `half` and `radius` in metres.
void add_box(Layer& layer, const View& view, const Placement& at, Vec2 half, float radius, Paint paint) {
    if (!view.is_in_view(at.center, view.scale * (length(half) + radius))) return;
    layer.boxes.push_back({to_float(at.center.x), to_float(at.center.y), at.axis.x, at.axis.y,
                           to_float(view.scale * half.x), to_float(view.scale * half.y), to_float(view.scale * radius),
                           paint});
}

void add_capsule(Layer& layer, const View& view, const Shape& shape, const Pose& pose, Paint paint) {
    const Vec2 from = shape.vertex(0);
    const Vec2 along = shape.vertex(1) - from;
    const float size = length(along);
    const Vec2 axis = size > 0.0f ? (1.0f / size) * along : Vec2{1.0f, 0.0f};
    add_box(layer, view, place(view, pose, from + 0.5f * along, axis), {0.5f * size, 0.0f}, shape.radius(), paint);
}

void add_polygon(Layer& layer, const View& view, const Shape& shape, const Pose& pose, Paint paint) {
    const TightBox box = tight_box(shape);
    const Placement at = place(view, pose, box.center, box.axis);
    if (box.is_exact) return add_box(layer, view, at, box.half, shape.radius(), paint);
    if (!view.is_in_view(at.center, view.scale * (length(box.half) + shape.radius()))) return;
    TUMBLE_CHECK(shape.vertex_count() <= static_cast<int>(PolygonInstance::kVertices));

    PolygonInstance polygon{to_float(at.center.x),
                            to_float(at.center.y),
                            at.axis.x,
                            at.axis.y,
                            to_float(view.scale * box.half.x),
                            to_float(view.scale * box.half.y),
                            to_float(view.scale * shape.radius()),
                            {},
                            paint};
    for (std::size_t i = 0; i < PolygonInstance::kVertices; ++i) {
        const int vertex = static_cast<int>(i) < shape.vertex_count() ? static_cast<int>(i) : 0;
        const Vec2 offset = shape.vertex(vertex) - box.center;
        polygon.vertices[2 * i] = to_float(view.scale * dot(offset, box.axis));
        polygon.vertices[2 * i + 1] = to_float(view.scale * cross(box.axis, offset));
    }
    (shape.radius() > 0.0f ? layer.rounded_polygons : layer.polygons).push_back(polygon);
}

struct Interval {
    float lower = std::numeric_limits<float>::infinity();
    float upper = -std::numeric_limits<float>::infinity();

    void add(float value) {
        lower = std::min(lower, value);
        upper = std::max(upper, value);
    }
    float middle() const { return 0.5f * (lower + upper); }
    float half() const { return 0.5f * (upper - lower); }
};

// True for four right angles; the cosines may be off by 1e-4.
bool is_rectangle(const Shape& shape) {
    if (shape.vertex_count() != 4) return false;
    for (int i = 0; i < 4; ++i) {
        const Vec2 here = shape.vertex((i + 1) & 3) - shape.vertex(i);
        const Vec2 next = shape.vertex((i + 2) & 3) - shape.vertex((i + 1) & 3);
        const float cosine = dot(here, next);
        if (cosine * cosine > 1e-8f * length_sq(here) * length_sq(next)) return false;
    }
    return true;
}

}  // namespace

TightBox tight_box(const Shape& shape) {
    TightBox best;
    float least_area = std::numeric_limits<float>::infinity();
    const int count = shape.vertex_count();
    TUMBLE_CHECK(3 <= count);
    TUMBLE_CHECK(count <= Shape::kInlineVertices);
    for (int i = 0; i < count; ++i) {
        const Vec2 edge = shape.vertex(i + 1 < count ? i + 1 : 0) - shape.vertex(i);
        const float size = length(edge);
        if (size == 0.0f) continue;
        const Vec2 axis = (1.0f / size) * edge;
        Interval along, across;
        for (int j = 0; j < count; ++j) {
            along.add(dot(axis, shape.vertex(j)));
            across.add(cross(axis, shape.vertex(j)));
        }
        const float area = along.half() * across.half();
        if (area >= least_area) continue;
        least_area = area;
        best.axis = axis;
        best.half = {along.half(), across.half()};
        best.center = along.middle() * axis + across.middle() * perp(axis);
        if (i == 0 && is_rectangle(shape)) {
            best.is_exact = true;
            break;
        }
    }
    return best;
}

BoxInstance make_line(DVec2 from, DVec2 to, double width, Color color) {
    const DVec2 along = to - from;
    const double size = length(along);
    TUMBLE_CHECK(width >= 0.0);
    const DVec2 axis = size > 0.0 ? (1.0 / size) * along : DVec2{1.0, 0.0};
    const DVec2 center = 0.5 * (from + to);
    return {to_float(center.x),    to_float(center.y), to_float(axis.x), to_float(axis.y), to_float(0.5 * size), 0.0f,
            to_float(0.5 * width), flat(color)};
}

void add_line(Layer& layer, const View& view, DVec2 from, DVec2 to, double width, Color color) {
    if (clip_segment(view, kClipMargin + width, from, to)) layer.boxes.push_back(make_line(from, to, width, color));
}

void add_shape(Layer& layer, const View& view, const Shape& shape, const Pose& pose, Paint paint, double line_width) {
    const int count = shape.vertex_count();
    if (count == 0) return;
    if (count == 2 && shape.radius() == 0.0f) {
        const DVec2 from = view.to_pixels(transform_point(pose, shape.vertex(0)));
        const DVec2 to = view.to_pixels(transform_point(pose, shape.vertex(1)));
        return add_line(layer, view, from, to, line_width, paint.outline);
    }
    if (count > Shape::kInlineVertices || view.scale * extent(shape).larger > kLargestInstance)
        return add_outline_mesh(layer.mesh, view, shape, pose, paint);
    if (count == 1) return add_circle(layer, view, shape, pose, paint);
    if (count == 2) return add_capsule(layer, view, shape, pose, paint);
    add_polygon(layer, view, shape, pose, paint);
}

}  // namespace tumble::render
