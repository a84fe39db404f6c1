#include "dynamics/stages/impact.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "dynamics/bodies/constants.hpp"
#include "tumble/chain_manifold.hpp"

namespace tumble {

namespace {

// Along the longest edge, unit.
Vec2 long_axis(const Shape& shape) {
    Vec2 longest{1.0f, 0.0f};
    float size = 0.0f;
    for (int i = 0; i < shape.vertex_count(); ++i) {
        const Vec2 edge = shape.vertex((i + 1) % shape.vertex_count()) - shape.vertex(i);
        if (length(edge) > size) size = length(edge), longest = (1.0f / size) * edge;
    }
    return longest;
}

// A shape shrunk about its middle to a part of its thickness, and by as much of its length: the tip of a bar is no more
// to pass than its side. 0 leaves the middle point.
Shape core_of(const ShapeRecord& record, float part) {
    const Shape& shape = record.shape;
    const Vec2 middle = mass_properties(shape).center;
    if (part == 0.0f || shape.vertex_count() > Shape::kInlineVertices)
        return make_circle(0.5f * part * record.smaller_extent, middle);
    const Vec2 along = long_axis(shape), across = perp(along);
    Vec2 reach;
    for (int i = 0; i < shape.vertex_count(); ++i) {
        const Vec2 arm = shape.vertex(i) - middle;
        reach = {std::max(reach.x, std::abs(dot(along, arm))), std::max(reach.y, std::abs(dot(across, arm)))};
    }
    const float inset = (1.0f - part) * (0.5f * record.smaller_extent - shape.radius());
    const auto scale = [&](float way) { return way > 0.0f ? std::max(part, 1.0f - inset / way) : part; };
    const float scale_along = scale(reach.x), scale_across = scale(reach.y);
    std::array<Vec2, Shape::kInlineVertices> vertices;
    for (int i = 0; i < shape.vertex_count(); ++i) {
        const Vec2 arm = shape.vertex(i) - middle;
        vertices[static_cast<std::size_t>(i)] =
            middle + (scale_along * dot(along, arm)) * along + (scale_across * dot(across, arm)) * across;
    }
    return Shape::from_raw({vertices.data(), static_cast<std::size_t>(shape.vertex_count())}, part * shape.radius());
}

}  // namespace

double impact(const ShapeRecord& moving, const Sweep& sweep, const ShapeRecord& other, const Sweep& other_sweep,
              bool is_held) {
    if (other.link && is_behind(other.shape, *other.link, pose_at(other_sweep, 0.0), moving.shape, pose_at(sweep, 0.0)))
        return 1.0;
    for (const float part : kContinuousCores) {
        const CastResult core = time_of_impact(other.shape, other_sweep, core_of(moving, part), sweep);
        if (core.status == CastStatus::overlapping) continue;
        if (core.status != CastStatus::hit) return 1.0;
        if (part < kContinuousCores[0]) return 0.0;
        if (is_held) return core.fraction;
        const CastResult surface = time_of_impact(other.shape, other_sweep, moving.shape, sweep);
        const bool touched = surface.status != CastStatus::hit || surface.fraction <= 0.0;
        return touched ? core.fraction : surface.fraction;
    }
    return 1.0;
}

}  // namespace tumble
