#include "reference/query/random_shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "debug/check.hpp"

namespace tumble::reference {

namespace {

std::int64_t cross(GridPoint a, GridPoint b, GridPoint c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Adds the chain below (or above, for reversed points) of a hull, without its last point.
template <class Range>
void add_chain(std::vector<GridPoint>& hull, const Range& points) {
    const std::size_t start = hull.size();
    for (const GridPoint point : points) {
        while (hull.size() >= start + 2 && cross(hull[hull.size() - 2], hull.back(), point) <= 0) hull.pop_back();
        hull.push_back(point);
    }
    hull.pop_back();
}

GridPoint to_grid(DVec2 point) { return {std::llround(point.x), std::llround(point.y)}; }

struct WorldEdge {
    DVec2 from, to;
    DVec2 outward;  // unit up to rounding
};

// A random edge of the core in world axes relative to the shape's position; (1, 0) points out of a lone vertex.
WorldEdge random_edge(const Shape& shape, Rotation q, Random& random) {
    const int count = shape.vertex_count();
    const int i = random.integer(0, count - 1);
    const DVec2 from = rotate(q, DVec2(shape.vertex(i)));
    const DVec2 to = rotate(q, DVec2(shape.vertex(i + 1 == count ? 0 : i + 1)));
    const double side = length(to - from);
    return {from, to, side > 0.0 ? (1.0 / side) * -perp(to - from) : DVec2{1.0, 0.0}};
}

double radii(const PairQuery& query) { return double{query.a.radius()} + double{query.b.radius()}; }

}  // namespace

std::vector<GridPoint> convex_hull(std::vector<GridPoint> points) {
    std::ranges::sort(points);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 3) return points;
    std::vector<GridPoint> hull;
    hull.reserve(points.size() + 1);
    add_chain(hull, points);
    std::ranges::reverse(points);
    add_chain(hull, points);
    return hull;
}

std::vector<Vec2> to_vertices(std::span<const GridPoint> points, int x_exponent, int y_exponent) {
    std::vector<Vec2> vertices;
    vertices.reserve(points.size());
    for (const GridPoint point : points) {
        TUMBLE_CHECK(std::abs(point.x) < kGridLimit);
        TUMBLE_CHECK(std::abs(point.y) < kGridLimit);
        vertices.push_back(
            {std::ldexp(static_cast<float>(point.x), x_exponent), std::ldexp(static_cast<float>(point.y), y_exponent)});
    }
    return vertices;
}

Shape random_polygon(Random& random, int max_vertices, int exponent, double radius) {
    const int count = random.integer(3, max_vertices);
    const double extent = random.uniform(0x1p21, 0x1p22);
    const bool on_circle = random.chance(0.5);
    const DVec2 center = random.chance(0.5) ? DVec2{} : random.point(0x1p22);
    std::vector<GridPoint> points;
    points.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i)
        points.push_back(to_grid(center + (on_circle ? extent * random.direction() : random.point(extent))));
    return Shape::from_raw(to_vertices(convex_hull(std::move(points)), exponent - 22, exponent - 22),
                           static_cast<float>(radius));
}

Shape box(double half_width, double half_height, double radius, Vec2 center) {
    const auto hx = static_cast<float>(half_width), hy = static_cast<float>(half_height);
    const float left = center.x - hx, right = center.x + hx, low = center.y - hy, high = center.y + hy;
    const std::array<Vec2, 4> vertices{{{left, low}, {right, low}, {right, high}, {left, high}}};
    return Shape::from_raw(vertices, static_cast<float>(radius));
}

Shape random_box(Random& random, int exponent, double radius) {
    const double half_width = random.magnitude(exponent - 2, exponent - 1);
    return box(half_width, random.magnitude(exponent - 2, exponent - 1), radius);
}

Shape random_shape(Random& random, int exponent) {
    const double size = std::ldexp(1.0, exponent);
    const double radius = size * random.uniform(0.01, 0.5);
    const auto local_point = [&] { return to_float(random.point(size)); };
    switch (random.integer(0, 9)) {
        case 0:
            return Shape::from_raw(std::array{random.chance(0.7) ? Vec2{} : local_point()}, static_cast<float>(radius));
        case 1: return Shape::from_raw(std::array{local_point(), local_point()}, static_cast<float>(radius));
        case 2: return Shape::from_raw(std::array{local_point(), local_point()}, 0.0f);
        case 3:
        case 4: return random_box(random, exponent);
        case 5: return random_box(random, exponent, radius);
        case 6: return random_polygon(random, 8, exponent, radius);
        default: return random_polygon(random, 8, exponent);
    }
}

DVec2 support_point(const Shape& shape, Rotation q, DVec2 direction) {
    DVec2 best = rotate(q, DVec2(shape.vertex(0)));
    for (int i = 1; i < shape.vertex_count(); ++i) {
        const DVec2 vertex = rotate(q, DVec2(shape.vertex(i)));
        if (dot(vertex, direction) > dot(best, direction)) best = vertex;
    }
    return best;
}

void place_vertex_to_vertex(PairQuery& query, DVec2 normal, double gap) {
    const DVec2 on_a = support_point(query.a, query.pose_a.rotation, normal);
    const DVec2 on_b = support_point(query.b, query.pose_b.rotation, -normal);
    query.pose_b.position = query.pose_a.position + (on_a - on_b + (gap + radii(query)) * normal);
}

void place_vertex_to_vertex(PairQuery& query, Random& random, double gap) {
    place_vertex_to_vertex(query, random.direction(), gap);
}

void place_vertex_to_edge(PairQuery& query, Random& random, double gap) {
    if (random.chance(0.5)) {
        const WorldEdge edge = random_edge(query.a, query.pose_a.rotation, random);
        const DVec2 on_a = edge.from + random.uniform() * (edge.to - edge.from);
        const DVec2 on_b = support_point(query.b, query.pose_b.rotation, -edge.outward);
        query.pose_b.position = query.pose_a.position + (on_a - on_b + (gap + radii(query)) * edge.outward);
    } else {
        const WorldEdge edge = random_edge(query.b, query.pose_b.rotation, random);
        const DVec2 on_b = edge.from + random.uniform() * (edge.to - edge.from);
        const DVec2 on_a = support_point(query.a, query.pose_a.rotation, -edge.outward);
        query.pose_b.position = query.pose_a.position + (on_a - on_b - (gap + radii(query)) * edge.outward);
    }
}

void place_edge_to_edge(PairQuery& query, Random& random, double gap, double angle) {
    const WorldEdge on_a = random_edge(query.a, query.pose_a.rotation, random);
    const WorldEdge local_b = random_edge(query.b, {}, random);
    const double turn =
        arc_tangent(-on_a.outward.y, -on_a.outward.x) - arc_tangent(local_b.outward.y, local_b.outward.x);
    query.pose_b.rotation = make_rotation(turn + angle);
    const DVec2 from_b = rotate(query.pose_b.rotation, local_b.from), to_b = rotate(query.pose_b.rotation, local_b.to);
    const DVec2 point_a = on_a.from + random.uniform() * (on_a.to - on_a.from);
    const DVec2 point_b = from_b + random.uniform() * (to_b - from_b);
    query.pose_b.position = query.pose_a.position + (point_a - point_b + (gap + radii(query)) * on_a.outward);
}

}  // namespace tumble::reference
