// The two convex cores of a query, in world axes relative to A's position.
//
// Vertices are turned by their own rotation only, and B's are shifted by the offset of the positions. Swapping the
// shapes then negates every number exactly, and far from the origin only the offset rounds.
#pragma once

#include <algorithm>
#include <cmath>

#include "debug/check.hpp"
#include "simd/lane_function.hpp"
#include "tumble/math.hpp"
#include "tumble/shape.hpp"

namespace tumble {

// A core's vertices and its rotation, widened to double. What turns vectors is always inlined: a call would move the
// core, and all that is in registers around it, through memory.
struct Core {
    const float* x;
    const float* y;
    int count;
    double c;
    double s;
    const LargePolygon* large;  // null for at most eight vertices
    bool is_convex;

    // A vector of the shape's coordinates in world axes, and back.
    [[gnu::always_inline]] DVec2 turned(DVec2 v) const { return {c * v.x - s * v.y, s * v.x + c * v.y}; }
    [[gnu::always_inline]] DVec2 turned_back(DVec2 v) const { return {c * v.x + s * v.y, c * v.y - s * v.x}; }

    // A vertex in world axes, relative to the body's position. Products of two floats are exact in double: each
    // coordinate carries one rounding.
    [[gnu::always_inline]] DVec2 point(int index) const {
        TUMBLE_CHECK(index >= 0);
        TUMBLE_CHECK(index < count);
        return turned({x[index], y[index]});
    }

    // The edge from one vertex to another: as a difference of local coordinates it keeps its relative accuracy however
    // short it is.
    [[gnu::always_inline]] DVec2 edge(int from, int to) const {
        TUMBLE_CHECK(to < count);
        return turned(local_edge(from, to));
    }
    [[gnu::always_inline]] DVec2 local_edge(int from, int to) const {
        return {static_cast<double>(x[to]) - x[from], static_cast<double>(y[to]) - y[from]};
    }

    // The neighbours of a vertex, without branches, since a processor could not predict them.
    int next(int index) const { return (index + 1) & -static_cast<int>(index + 1 != count); }
    int previous(int index) const { return index - 1 + (count & -static_cast<int>(index == 0)); }
};

struct CorePair {
    Core a;
    Core b;
    DVec2 offset;  // from A's position to B's
    double scale;  // S, at least |qA| RA + |qB| RB + |offset|: error bounds are relative to it
};

[[gnu::always_inline]] inline Core make_core(const Shape& shape, Rotation q) {
    return {shape.x().data(), shape.y().data(), shape.vertex_count(), q.c, q.s, shape.large(), shape.is_convex()};
}

// True if the edges of both outlines are the faces of A - B, few enough to be computed in lanes.
[[gnu::always_inline]] inline bool has_few_faces(const CorePair& pair) {
    return std::max(pair.a.count, pair.b.count) <= Shape::kInlineVertices && pair.a.is_convex && pair.b.is_convex;
}

// |q| R for the core radius R: |q| <= (1 + |q|^2) / 2, equal for unit rotations and without a root.
template <typename Number>
TUMBLE_LANE_FUNCTION Number turned_radius(const Number& c, const Number& s, const Number& core_radius) {
    return 0.5 * (Number(1.0) + (c * c + s * s)) * core_radius;
}

[[gnu::always_inline]] inline double turned_radius(const Shape& shape, Rotation q) {
    return turned_radius(double{q.c}, double{q.s}, shape.core_radius());
}

[[gnu::always_inline]] inline CorePair make_core_pair(const Shape& a, const Pose& world_from_a, const Shape& b,
                                                      const Pose& world_from_b) {
    const DVec2 offset = world_from_b.position - world_from_a.position;
    const double radii = turned_radius(a, world_from_a.rotation) + turned_radius(b, world_from_b.rotation);
    return {make_core(a, world_from_a.rotation), make_core(b, world_from_b.rotation), offset, radii + length(offset)};
}

// The range of CorePair::scale, m, in which squares and their products neither overflow nor vanish.
inline constexpr double kLargestScale = 0x1p500;
inline constexpr double kSmallestScale = 0x1p-480;

[[gnu::always_inline]] inline bool are_radii_valid(const Shape& a, const Shape& b) {
    return a.radius() >= 0.0f && b.radius() >= 0.0f && std::isfinite(static_cast<double>(a.radius()) + b.radius());
}

// False for NaN, infinity, a shape without vertices, a negative radius, and a scale out of range. NaN fails each test.
[[gnu::always_inline]] inline bool is_valid(const CorePair& pair, const Shape& a, const Shape& b) {
    const bool in_range = pair.scale <= kLargestScale && (pair.scale >= kSmallestScale || pair.offset == DVec2{});
    return in_range && pair.a.count > 0 && pair.b.count > 0 && are_radii_valid(a, b);
}

}  // namespace tumble
