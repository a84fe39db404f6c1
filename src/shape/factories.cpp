// The factories: each checks its arguments, then passes the core vertices to Shape::from_raw().
#include <algorithm>
#include <array>
#include <sstream>
#include <stdexcept>

#include "debug/check.hpp"
#include "shape/arguments.hpp"
#include "shape/hull.hpp"
#include "shape/orientation.hpp"
#include "tumble/shape.hpp"

namespace tumble {

namespace {

// Sine and cosine in double: the corners of a box then carry a single rounding to float.
SinCos turn(double angle) { return angle == 0.0 ? SinCos{} : sin_cos(angle); }

bool is_strictly_convex(std::span<const Vec2> vertices) {
    const std::size_t count = vertices.size();
    for (std::size_t i = 0; i < count; ++i)
        if (orientation(vertices[i], vertices[(i + 1) % count], vertices[(i + 2) % count]) <= 0) return false;
    return true;
}

double larger_side(std::span<const Vec2> points) {
    Vec2 lower = points[0], upper = points[0];
    for (const Vec2 point : points) {
        lower = {std::min(lower.x, point.x), std::min(lower.y, point.y)};
        upper = {std::max(upper.x, point.x), std::max(upper.y, point.y)};
    }
    const DVec2 size = DVec2(upper) - DVec2(lower);
    return std::max(size.x, size.y);
}

}  // namespace

Shape make_circle(float radius, Vec2 center) {
    require_radius(radius);
    require_finite("circle center", center);
    return Shape::from_raw({&center, 1}, radius);
}

Shape make_capsule(Vec2 from, Vec2 to, float radius) {
    require_radius(radius);
    require_finite("capsule end 'from'", from);
    require_finite("capsule end 'to'", to);
    const std::array<Vec2, 2> ends = {from, to};
    return Shape::from_raw({ends.data(), from == to ? 1u : 2u}, radius);
}

Shape make_segment(Vec2 from, Vec2 to) { return make_capsule(from, to, 0.0f); }

Shape make_box(Vec2 size, float radius, Vec2 center, double angle) {
    require_box(size, radius);
    require_finite("box center", center);
    require_finite("box angle", angle);
    const DVec2 half(0.5 * size.x - radius, 0.5 * size.y - radius);
    TUMBLE_CHECK(half.x >= 0.0);
    TUMBLE_CHECK(half.y >= 0.0);
    const SinCos q = turn(angle);
    const auto corner = [&](double x, double y) {
        return to_float(DVec2(center) + DVec2(q.cos * x - q.sin * y, q.sin * x + q.cos * y));
    };
    if (half.x == 0.0 || half.y == 0.0) return make_capsule(corner(-half.x, -half.y), corner(half.x, half.y), radius);
    const std::array<Vec2, 4> corners = {corner(-half.x, -half.y), corner(half.x, -half.y), corner(half.x, half.y),
                                         corner(-half.x, half.y)};
    if (!is_strictly_convex(corners)) {
        std::ostringstream message;
        message << "a box of size (" << size.x << ", " << size.y << ") and radius " << radius
                << " does not have distinct corners in float at center (" << center.x << ", " << center.y << ')';
        throw std::invalid_argument(message.str());
    }
    return Shape::from_raw(corners, radius);
}

Shape make_polygon(std::span<const Vec2> points, float radius, HullReport* report) {
    require_radius(radius);
    require_points(points, 1);
    const double tolerance = static_cast<double>(kWeldTolerance) * larger_side(points);
    const std::vector<Vec2> kept = simplify_hull(convex_hull(points), tolerance);
    if (report) *report = classify_points(points, kept, tolerance);
    return Shape::from_raw(kept, radius);
}

Shape make_exact_polygon(std::span<const Vec2> points, float radius) {
    require_radius(radius);
    require_points(points, 1);
    return Shape::from_raw(convex_hull(points), radius);
}

std::vector<Shape> make_chain(std::span<const Vec2> points, bool loop) {
    require_points(points, 2);
    std::vector<Shape> segments;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) segments.push_back(make_segment(points[i], points[i + 1]));
    if (loop) segments.push_back(make_segment(points.back(), points.front()));
    return segments;
}

}  // namespace tumble
