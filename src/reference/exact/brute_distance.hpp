// An oracle for signed distances: exhaustive over all vertices and edges, in long double (64-bit mantissa on x86-64),
// hence 2^11 times finer than the narrow phase. It shares no code with the narrow phase.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "debug/check.hpp"
#include "tumble/shape.hpp"

namespace tumble::reference::brute {

using Real = long double;

struct Point {
    Real x;
    Real y;
};

inline Real cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }
inline Real dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
inline Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
inline Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
inline Point operator*(Real s, Point a) { return {s * a.x, s * a.y}; }
inline Real norm(Point a) { return std::sqrt(dot(a, a)); }

// World vertices relative to `origin`.
inline std::vector<Point> world_vertices(const Shape& shape, const Pose& pose, DVec2 origin) {
    std::vector<Point> vertices;
    vertices.reserve(static_cast<std::size_t>(shape.vertex_count()));
    const Real c = pose.rotation.c, s = pose.rotation.s;
    for (int i = 0; i < shape.vertex_count(); ++i) {
        const Real x = shape.vertex(i).x, y = shape.vertex(i).y;
        vertices.push_back({c * x - s * y + (static_cast<Real>(pose.position.x) - origin.x),
                            s * x + c * y + (static_cast<Real>(pose.position.y) - origin.y)});
    }
    return vertices;
}

inline Real distance_to_segment(Point p, Point from, Point to) {
    const Point e = to - from, d = p - from;
    const Real ee = dot(e, e);
    if (ee == 0) return norm(d);
    const Real t = dot(d, e) / ee;
    if (t <= 0) return norm(d);
    if (t >= 1) return norm(p - to);
    return std::abs(cross(e, d)) / std::sqrt(ee);
}

inline Real distance_of_boundaries(const std::vector<Point>& a, const std::vector<Point>& b) {
    TUMBLE_CHECK(!a.empty());
    TUMBLE_CHECK(!b.empty());
    Real nearest = INFINITY;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j) {
            nearest = std::min(nearest, distance_to_segment(a[i], b[j], b[(j + 1) % b.size()]));
            nearest = std::min(nearest, distance_to_segment(b[j], a[i], a[(i + 1) % a.size()]));
        }
    return nearest;
}

// The largest separation along an outward edge normal of `a`, or the first that is not negative, if there is one;
// -infinity for a point.
inline Real face_separation(const std::vector<Point>& a, const std::vector<Point>& b) {
    Real largest = -INFINITY;
    for (std::size_t i = 0; i < a.size() && largest < 0; ++i) {
        const Point e = a[(i + 1) % a.size()] - a[i];
        const Real length = norm(e);
        if (length == 0) continue;
        Real lowest = INFINITY;
        for (const Point& p : b) lowest = std::min(lowest, cross(p - a[i], e));
        largest = std::max(largest, lowest / length);
    }
    return largest;
}

// Signed core distance. The largest face separation is the answer if it is negative. Otherwise, and for two points,
// which have no faces, the distance of the boundaries is the answer.
inline Real core_distance(const std::vector<Point>& a, const std::vector<Point>& b) {
    Real separation = face_separation(a, b);
    if (separation < 0) separation = std::max(separation, face_separation(b, a));
    return separation < 0 && std::isfinite(separation) ? separation : distance_of_boundaries(a, b);
}

inline Real brute_distance(const Shape& a, const Pose& world_from_a, const Shape& b, const Pose& world_from_b) {
    const std::vector<Point> va = world_vertices(a, world_from_a, world_from_a.position);
    const std::vector<Point> vb = world_vertices(b, world_from_b, world_from_a.position);
    return core_distance(va, vb) - (static_cast<Real>(a.radius()) + b.radius());
}

}  // namespace tumble::reference::brute
