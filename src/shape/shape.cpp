// Shape itself: vertices inline up to eight, shared beyond.
#include "tumble/shape.hpp"

#include <algorithm>
#include <cmath>

#include "debug/check.hpp"
#include "shape/arguments.hpp"
#include "shape/convexity.hpp"
#include "shape/edge_angles.hpp"

namespace tumble {

bool operator==(const Shape& a, const Shape& b) noexcept {
    return a.count_ == b.count_ && a.radius_ == b.radius_ && std::ranges::equal(a.x(), b.x()) &&
           std::ranges::equal(a.y(), b.y());
}

Shape Shape::from_raw(std::span<const Vec2> vertices, float radius) {
    require_vertex_count(vertices.size());
    Shape shape;
    shape.count_ = static_cast<std::uint16_t>(vertices.size());
    shape.radius_ = radius;
    double farthest_sq = 0.0;
    for (const Vec2 vertex : vertices) {
        const double distance_sq = length_sq(DVec2(vertex));
        if (!(distance_sq <= farthest_sq)) farthest_sq = distance_sq;  // true for NaN, too
        if (std::isnan(farthest_sq)) break;                            // no number compares as larger
    }
    shape.core_radius_ = std::sqrt(farthest_sq);
    if (vertices.size() > kInlineVertices) {
        auto large = std::make_shared<LargePolygon>();
        for (const Vec2 vertex : vertices) {
            large->x.push_back(vertex.x);
            large->y.push_back(vertex.y);
        }
        sort_edges(*large);
        shape.is_convex_ = !large->edge_angles.empty();
        TUMBLE_CHECK((large->edge_angles.empty() || large->edge_angles.size() == vertices.size()));
        shape.large_ = std::move(large);
        return shape;
    }
    shape.is_convex_ = is_convex_outline(vertices);
    for (std::size_t lane = 0; lane < kInlineVertices && !vertices.empty(); ++lane) {
        const Vec2 vertex = vertices[lane < vertices.size() ? lane : 0];
        shape.x_[lane] = vertex.x;
        shape.y_[lane] = vertex.y;
    }
    return shape;
}

}  // namespace tumble
