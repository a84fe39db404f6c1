#include "shape/arguments.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

#include "tumble/shape.hpp"

namespace tumble {

namespace {

std::ostream& operator<<(std::ostream& out, Vec2 v) { return out << '(' << v.x << ", " << v.y << ')'; }

template <typename... Parts>
void require(bool condition, const Parts&... parts) {
    if (condition) return;
    std::ostringstream message;
    message.precision(9);
    (message << ... << parts);
    throw std::invalid_argument(message.str());
}

}  // namespace

void require_vertex_count(std::size_t count) {
    require(count <= static_cast<std::size_t>(Shape::kMaxVertices), "a shape has at most ", Shape::kMaxVertices,
            " vertices, got ", count);
}

void require_radius(float radius) {
    require(std::isfinite(radius) && radius >= 0.0f, "radius must be finite and not negative, got ", radius);
}

void require_finite(const char* what, Vec2 point) { require(is_finite(point), what, " must be finite, got ", point); }

void require_finite(const char* what, double value) {
    require(std::isfinite(value), what, " must be finite, got ", value);
}

void require_points(std::span<const Vec2> points, std::size_t at_least) {
    require(points.size() >= at_least, "at least ", at_least, " points are needed, got ", points.size());
    for (std::size_t index = 0; index < points.size(); ++index)
        require(is_finite(points[index]), "point ", index, " must be finite, got ", points[index]);
}

void require_box(Vec2 size, float radius) {
    require(is_finite(size) && size.x > 0.0f && size.y > 0.0f, "box size must be finite and greater than 0, got ",
            size);
    require_radius(radius);
    require(radius <= 0.5f * std::min(size.x, size.y), "box radius must be at most half the smaller side of ", size,
            ", got ", radius);
}

}  // namespace tumble
