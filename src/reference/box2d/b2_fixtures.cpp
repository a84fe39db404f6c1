#include "reference/box2d/b2_fixtures.hpp"

#include <box2d/box2d.h>

#include <algorithm>
#include <span>
#include <vector>

namespace tumble::reference {

namespace {

b2FixtureDef fixture_def(const b2Shape& shape, const SurfaceMaterial& material) {
    b2FixtureDef def;
    def.shape = &shape;
    def.friction = material.friction;
    def.restitution = material.restitution;
    return def;
}

void add_circle(b2Body& body, Vec2 center, float radius, const SurfaceMaterial& material) {
    b2CircleShape circle;
    circle.m_p.Set(center.x, center.y);
    circle.m_radius = radius;
    const b2FixtureDef def = fixture_def(circle, material);
    body.CreateFixture(&def);
}

// The members that b2PolygonShape::Set() would fill, without its welding. Vertices convex and counter-clockwise, 3 to
// 8, with area and without repeats.
void add_polygon(b2Body& body, std::span<const Vec2> vertices, float radius, const SurfaceMaterial& material) {
    b2PolygonShape polygon;
    polygon.m_count = static_cast<int32>(vertices.size());
    if (radius > 0.0f) polygon.m_radius = radius;
    double area = 0.0;
    DVec2 moment;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const DVec2 from(vertices[i]), to(vertices[(i + 1) % vertices.size()]);
        const DVec2 outward = (1.0 / length(to - from)) * -perp(to - from);
        polygon.m_vertices[i].Set(vertices[i].x, vertices[i].y);
        polygon.m_normals[i].Set(static_cast<float>(outward.x), static_cast<float>(outward.y));
        const DVec2 origin(vertices[0]);
        const double triangle = cross(from - origin, to - origin);
        area += triangle;
        moment += (triangle / 3.0) * ((from - origin) + (to - origin));
    }
    const Vec2 centroid = to_float(DVec2(vertices[0]) + (1.0 / area) * moment);
    polygon.m_centroid.Set(centroid.x, centroid.y);
    const b2FixtureDef def = fixture_def(polygon, material);
    body.CreateFixture(&def);
}

bool add_segment(b2Body& body, Vec2 from, Vec2 to, const SurfaceMaterial& material) {
    if (from == to) return false;
    b2EdgeShape edge;
    edge.SetTwoSided({from.x, from.y}, {to.x, to.y});
    const b2FixtureDef def = fixture_def(edge, material);
    body.CreateFixture(&def);
    return true;
}

void add_capsule(b2Body& body, Vec2 from, Vec2 to, float radius, const SurfaceMaterial& material) {
    const DVec2 axis = DVec2(to) - DVec2(from);
    if (length(axis) > 0.0) {
        const Vec2 side = to_float((static_cast<double>(radius) / length(axis)) * perp(axis));
        const Vec2 corners[] = {from - side, to - side, to + side, from + side};
        // Without a skin, flush with the circles.
        add_polygon(body, corners, b2_linearSlop * 1e-3f, material);
    }
    add_circle(body, from, radius, material);
    add_circle(body, to, radius, material);
}

std::vector<Vec2> distinct_vertices(const Shape& shape) {
    std::vector<Vec2> vertices;
    for (int i = 0; i < shape.vertex_count(); ++i)
        if (vertices.empty() || shape.vertex(i) != vertices.back()) vertices.push_back(shape.vertex(i));
    while (vertices.size() > 1 && vertices.front() == vertices.back()) vertices.pop_back();
    return vertices;
}

bool has_area(std::span<const Vec2> vertices) {
    double area = 0.0;
    for (std::size_t i = 2; i < vertices.size(); ++i)
        area += cross(DVec2(vertices[i - 1]) - DVec2(vertices[0]), DVec2(vertices[i]) - DVec2(vertices[0]));
    return area > 0.0;
}

// A fan about the first vertex, b2_maxPolygonVertices at a time, each part sharing an edge with the next.
bool add_fan(b2Body& body, const std::vector<Vec2>& vertices, float radius, const SurfaceMaterial& material) {
    bool added = false;
    for (std::size_t begin = 1; begin + 1 < vertices.size(); begin += b2_maxPolygonVertices - 2) {
        const std::size_t end = std::min(begin + b2_maxPolygonVertices - 1, vertices.size());
        std::vector<Vec2> part{vertices[0]};
        part.insert(part.end(), vertices.begin() + static_cast<std::ptrdiff_t>(begin),
                    vertices.begin() + static_cast<std::ptrdiff_t>(end));
        if (!has_area(part)) continue;
        add_polygon(body, part, radius, material);
        added = true;
    }
    return added;
}

}  // namespace

bool add_fixtures(b2Body& body, const Shape& shape, const SurfaceMaterial& material) {
    const std::vector<Vec2> vertices = distinct_vertices(shape);
    if (vertices.empty()) return false;
    if (vertices.size() == 1) return add_circle(body, vertices[0], shape.radius(), material), true;
    if (vertices.size() > 2) return add_fan(body, vertices, shape.radius(), material);
    if (shape.radius() == 0.0f) return add_segment(body, vertices[0], vertices[1], material);
    return add_capsule(body, vertices[0], vertices[1], shape.radius(), material), true;
}

}  // namespace tumble::reference
