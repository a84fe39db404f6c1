// Area, centroid and second moment of a convex core grown by a radius: the core by Green's theorem, a rectangle of
// width r along each edge, a circular sector of radius r at each corner. All three are exact closed forms.
#include <algorithm>
#include <cmath>

#include "debug/check.hpp"
#include "tumble/shape.hpp"

namespace tumble {

namespace {

struct Moments {
    double area = 0.0;
    DVec2 first;          // integral of the position
    double second = 0.0;  // integral of its square

    void add_piece(double piece_area, DVec2 center, double second_about_center) {
        area += piece_area;
        first += piece_area * center;
        second += second_about_center + piece_area * length_sq(center);
    }
};

// The triangle of the origin and an edge; negative area where the origin lies outside.
void add_triangle(Moments& moments, DVec2 from, DVec2 to) {
    const double twice_area = cross(from, to);
    moments.area += twice_area / 2.0;
    moments.first += (twice_area / 6.0) * (from + to);
    moments.second += twice_area / 12.0 * (length_sq(from) + dot(from, to) + length_sq(to));
}

void add_edge_strip(Moments& moments, DVec2 from, DVec2 to, DVec2 normal, double radius) {
    const double side = length(to - from);
    const double area = side * radius;
    const DVec2 center = 0.5 * (from + to) + 0.5 * radius * normal;
    moments.add_piece(area, center, area * (side * side + radius * radius) / 12.0);
}

// The sector about `corner` from one normal to the next: its first moment is the integral of r^2 / 3 times the outward
// direction along the arc, which is a quarter turn of the normals' difference.
void add_corner_sector(Moments& moments, DVec2 corner, DVec2 from_normal, DVec2 to_normal, double angle,
                       double radius) {
    const double radius_sq = radius * radius;
    const double area = radius_sq * angle / 2.0;
    const DVec2 first = -(radius_sq * radius / 3.0) * perp(to_normal - from_normal);
    moments.area += area;
    moments.first += area * corner + first;
    moments.second += area * length_sq(corner) + 2.0 * dot(corner, first) + radius_sq * radius_sq * angle / 4.0;
}

// Vertices that differ from their predecessor, relative to `origin`.
std::vector<DVec2> distinct_vertices(const Shape& shape, DVec2 origin) {
    std::vector<DVec2> vertices;
    for (int i = 0; i < shape.vertex_count(); ++i) {
        const DVec2 vertex = DVec2(shape.vertex(i)) - origin;
        if (vertices.empty() || !(vertices.back() == vertex)) vertices.push_back(vertex);
    }
    while (vertices.size() > 1 && vertices.front() == vertices.back()) vertices.pop_back();
    return vertices;
}

Moments moments_about(const Shape& shape, DVec2 origin) {
    Moments moments;
    const std::vector<DVec2> vertices = distinct_vertices(shape, origin);
    const std::size_t count = vertices.size();
    TUMBLE_CHECK(count > 0u);
    const double radius = shape.radius();
    if (count == 1) {
        add_corner_sector(moments, vertices[0], {1, 0}, {1, 0}, 2.0 * kPi, radius);
        return moments;
    }
    const auto outward_normal = [&](std::size_t edge) {
        const DVec2 along = vertices[(edge + 1) % count] - vertices[edge];
        return (-1.0 / length(along)) * perp(along);
    };
    DVec2 previous = outward_normal(count - 1);
    for (std::size_t i = 0; i < count; ++i) {
        const DVec2 from = vertices[i], to = vertices[(i + 1) % count], normal = outward_normal(i);
        add_triangle(moments, from, to);
        if (radius > 0.0) {
            const double turn = std::abs(arc_tangent(cross(previous, normal), dot(previous, normal)));
            add_edge_strip(moments, from, to, normal, radius);
            add_corner_sector(moments, from, previous, normal, turn, radius);
        }
        previous = normal;
    }
    return moments;
}

DVec2 middle(const Shape& shape) {
    const auto [x_min, x_max] = std::ranges::minmax(shape.x());
    const auto [y_min, y_max] = std::ranges::minmax(shape.y());
    return 0.5 * (DVec2(x_min, y_min) + DVec2(x_max, y_max));
}

}  // namespace

// Integrates twice: about the middle for the centroid, then about the centroid for the inertia, so that no
// parallel-axis term cancels.
MassProperties mass_properties(const Shape& shape) {
    if (shape.vertex_count() == 0) return {};
    const DVec2 reference = middle(shape);
    const Moments about_reference = moments_about(shape, reference);
    if (!(about_reference.area > 0.0)) return {0.0, to_float(reference), 0.0};
    const DVec2 center = reference + (1.0 / about_reference.area) * about_reference.first;
    const Moments about_center = moments_about(shape, center);
    return {about_center.area, to_float(center), about_center.second};
}

}  // namespace tumble
