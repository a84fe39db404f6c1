#include "dynamics/continuous/shape_core.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "debug/check.hpp"

namespace tumble {

namespace {

// The direction of the longest edge, unit; (1, 0) if the shape has none.
Vec2 long_axis(const Shape& shape) {
    Vec2 longest{1.0f, 0.0f};
    float size = 0.0f;
    for (int i = 0; i < shape.vertex_count(); ++i) {
        const Vec2 edge = shape.vertex((i + 1) % shape.vertex_count()) - shape.vertex(i);
        if (length(edge) > size) size = length(edge), longest = (1.0f / size) * edge;
    }
    return longest;
}

}  // namespace

Shape core_of(const ShapeRecord& record, float part) {
    TUMBLE_CHECK(part >= 0.0f);
    TUMBLE_CHECK(part <= 1.0f);
    const Shape& shape = record.shape;
    const Vec2 middle = record.center;
    if (part == 0.0f || shape.vertex_count() > Shape::kInlineVertices)
        return make_circle(0.5f * part * record.smaller_extent, middle);
    const Vec2 along = long_axis(shape), across = perp(along);
    Vec2 reach;
    for (int i = 0; i < shape.vertex_count(); ++i) {
        const Vec2 arm = shape.vertex(i) - middle;
        reach = {std::max(reach.x, std::abs(dot(along, arm))), std::max(reach.y, std::abs(dot(across, arm)))};
    }
    const float inset = (1.0f - part) * (0.5f * record.smaller_extent - shape.radius());
    const auto scale = [&](float half) { return half > 0.0f ? std::max(part, 1.0f - inset / half) : part; };
    const float scale_along = scale(reach.x), scale_across = scale(reach.y);
    std::array<Vec2, Shape::kInlineVertices> vertices;
    for (int i = 0; i < shape.vertex_count(); ++i) {
        const Vec2 arm = shape.vertex(i) - middle;
        vertices[static_cast<std::size_t>(i)] =
            middle + (scale_along * dot(along, arm)) * along + (scale_across * dot(across, arm)) * across;
    }
    return Shape::from_raw({vertices.data(), static_cast<std::size_t>(shape.vertex_count())}, part * shape.radius());
}

}  // namespace tumble
