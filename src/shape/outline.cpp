// decompose_outline(): removes equal and straight points, proves the ring simple, triangulates it, merges triangles.
#include "tumble/outline.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "debug/check.hpp"
#include "shape/arguments.hpp"
#include "shape/convex_parts.hpp"
#include "shape/crossing.hpp"
#include "shape/triangulate.hpp"

namespace tumble {

namespace {

// The last index of each run of equal points, so that the edge from it is the one that leaves the run.
std::vector<std::size_t> distinct_points(const Ring& points) {
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (points[i] != points[points.next(i)]) kept.push_back(i);
    return kept;
}

std::vector<Vec2> pick(const Ring& ring, std::span<const std::size_t> indices) {
    std::vector<Vec2> picked;
    picked.reserve(indices.size());
    for (const std::size_t index : indices) picked.push_back(ring[index]);
    return picked;
}

std::vector<Vec2> without_straight_corners(const std::vector<Vec2>& points) {
    const Ring ring(points);
    std::vector<Vec2> corners;
    for (std::size_t i = 0; i < ring.size(); ++i)
        if (ring.turn(i) != 0) corners.push_back(ring[i]);
    return corners;
}

[[noreturn]] void refuse_crossing(const Ring& points, std::size_t edge, std::size_t other) {
    std::ostringstream message;
    message.precision(9);
    const auto name = [&](std::size_t start) {
        const Vec2 from = points[start], to = points[points.next(start)];
        message << start << " from (" << from.x << ", " << from.y << ") to (" << to.x << ", " << to.y << ')';
    };
    message << "an outline must not cross or touch itself: edge ";
    name(edge);
    message << " meets edge ";
    name(other);
    throw std::invalid_argument(message.str());
}

void require_simple(const Ring& points, std::span<const std::size_t> kept) {
    const std::vector<Vec2> distinct = pick(points, kept);
    const Ring ring(distinct);
    bool has_area = false;
    for (std::size_t i = 0; i < ring.size() && !has_area; ++i) has_area = ring.turn(i) != 0;
    if (!has_area) throw std::invalid_argument("an outline must have an area: all its points lie on one line");
    if (const auto crossing = find_crossing(ring))
        refuse_crossing(points, kept[crossing->first], kept[crossing->second]);
}

// The leftmost corner is convex: its turn has the sign of the winding.
bool is_clockwise(const std::vector<Vec2>& corners) {
    const auto leftmost = std::min_element(corners.begin(), corners.end(), is_before);
    return Ring(corners).turn(static_cast<std::size_t>(leftmost - corners.begin())) < 0;
}

Shape make_part(const Ring& ring, std::span<const std::size_t> corners) {
    std::vector<Vec2> vertices = without_straight_corners(pick(ring, corners));
    TUMBLE_CHECK(vertices.size() >= 3u);
    std::rotate(vertices.begin(), std::min_element(vertices.begin(), vertices.end(), is_before), vertices.end());
    return Shape::from_raw(vertices, 0.0f);
}

}  // namespace

std::vector<Shape> decompose_outline(std::span<const Vec2> points) {
    require_points(points, 3);
    const Ring given(points);
    const std::vector<std::size_t> kept = distinct_points(given);
    require_simple(given, kept);
    std::vector<Vec2> corners = without_straight_corners(pick(given, kept));
    if (is_clockwise(corners)) std::reverse(corners.begin(), corners.end());
    const Ring ring(corners);
    const std::vector<Triangle> triangles = triangulate(ring);
    TUMBLE_CHECK(triangles.size() + 2 == corners.size());
    std::vector<Shape> parts;
    for (const auto& part : merge_triangles(ring, triangles, static_cast<std::size_t>(Shape::kMaxVertices)))
        parts.push_back(make_part(ring, part));
    TUMBLE_CHECK(!parts.empty());
    TUMBLE_CHECK(parts.size() <= triangles.size());
    return parts;
}

}  // namespace tumble
