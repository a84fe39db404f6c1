// Random pairs of shapes of every kind, for properties of moving shapes, and how many of them to try.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "reference/query/random.hpp"
#include "support/pair_count.hpp"
#include "tumble/shape.hpp"

namespace tumble_test {

using tumble::reference::Random;

// Vertices of an ellipse in convex position: sharp corners for few, nearly smooth for many.
inline std::vector<tumble::Vec2> ellipse(Random& random, int count, double half_width, double half_height) {
    std::vector<tumble::Vec2> points;
    const double start = random.uniform(0.0, 6.0);
    for (int i = 0; i < count; ++i) {
        const tumble::SinCos v = tumble::sin_cos(start + (i + random.uniform(0.0, 0.8)) * 2.0 * tumble::kPi / count);
        points.push_back(tumble::to_float({half_width * v.cos, half_height * v.sin}));
    }
    return points;
}

enum class ShapeKind { circle, segment, capsule, box, polygon, rounded_polygon, large_polygon };
inline constexpr std::array kShapeKinds = {ShapeKind::circle,       ShapeKind::segment, ShapeKind::capsule,
                                           ShapeKind::box,          ShapeKind::polygon, ShapeKind::rounded_polygon,
                                           ShapeKind::large_polygon};

inline ShapeKind random_kind(Random& random) {
    return kShapeKinds[static_cast<std::size_t>(random.integer(0, static_cast<int>(kShapeKinds.size()) - 1))];
}

// About `size` metres.
inline tumble::Shape random_shape(Random& random, ShapeKind kind, double size) {
    const auto length = [&] { return static_cast<float>(size * random.uniform(0.1, 1.0)); };
    const auto end = [&] { return tumble::to_float(random.point(0.5 * size)); };
    switch (kind) {
        case ShapeKind::circle: return tumble::make_circle(0.5f * length(), end());
        case ShapeKind::segment: return tumble::make_segment(end(), end());
        case ShapeKind::capsule: return tumble::make_capsule(end(), end(), 0.3f * length());
        case ShapeKind::box: return tumble::make_box({length(), length()});
        case ShapeKind::polygon:
            return tumble::make_polygon(ellipse(random, random.integer(3, 8), 0.5 * size, 0.5 * length()));
        case ShapeKind::rounded_polygon:
            return tumble::make_polygon(ellipse(random, random.integer(3, 8), 0.4 * size, 0.4 * length()),
                                        0.2f * length());
        case ShapeKind::large_polygon:
            return tumble::make_polygon(ellipse(random, random.integer(9, 24), 0.5 * size, 0.5 * length()));
    }
    return {};
}

// The shape times a power of two.
inline tumble::Shape scaled(const tumble::Shape& shape, int exponent) {
    std::vector<tumble::Vec2> vertices;
    for (int i = 0; i < shape.vertex_count(); ++i)
        vertices.push_back({std::ldexp(shape.vertex(i).x, exponent), std::ldexp(shape.vertex(i).y, exponent)});
    return tumble::Shape::from_raw(vertices, std::ldexp(shape.radius(), exponent));
}

}  // namespace tumble_test
