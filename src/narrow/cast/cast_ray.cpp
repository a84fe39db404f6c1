// Ray casts: the cast of a point, with fast paths for circles and for sharp segments and polygons of up to eight
// vertices. They decide clear cases only: the start is outside by more than the error bound, and the entry, if any, is
// not near a vertex or a tangent. All others go through the general clipping, so that only one piece of code decides
// doubtful cases.
#include <algorithm>
#include <bit>

#include "debug/check.hpp"
#include "narrow/cast/cast_result.hpp"
#include "narrow/cores/error_bound.hpp"
#include "simd/double_lanes.hpp"

namespace tumble {

namespace {

struct Ray {
    Core core;
    DVec2 position;  // of the shape
    DVec2 offset;    // from there to the origin of the ray
    DVec2 motion;
    double motion_sq;
    double path;  // at least |motion|, at most its double; without a root
    double radius;
    double scale;  // at least the size and |offset|
    double error;  // E
};

// False if the case is not clear. Products of four lengths must not overflow or vanish.
[[gnu::always_inline]] inline bool is_moderate(double motion_sq, double scale) {
    constexpr double kLarge = 0x1p200, kSmall = 0x1p-200;
    return motion_sq < kLarge && motion_sq > kSmall && scale < kLarge && scale > kSmall;
}

[[gnu::always_inline]] inline Ray make_ray(const Shape& shape, const Pose& world_from_shape, DVec2 origin,
                                           DVec2 translation) {
    const DVec2 offset = origin - world_from_shape.position;
    const double radius = shape.radius();
    const double scale = turned_radius(shape, world_from_shape.rotation) + (std::abs(offset.x) + std::abs(offset.y));
    return {make_core(shape, world_from_shape.rotation),
            world_from_shape.position,
            offset,
            translation,
            length_sq(translation),
            std::abs(translation.x) + std::abs(translation.y),
            radius,
            scale,
            16.0 * kUnitRoundoff * (scale + radius)};
}

// Makes the ray again: as an argument it would pass through memory in the clear cases as well.
[[gnu::noinline]] CastResult cast_in_general(const Shape& shape, const Pose& world_from_shape, DVec2 origin,
                                             DVec2 translation) {
    static constexpr float kPoint = 0.0f;
    const Ray ray = make_ray(shape, world_from_shape, origin, translation);
    const CorePair pair{ray.core, {&kPoint, &kPoint, 1, 1.0, 0.0, nullptr, true}, ray.offset, ray.scale};
    if (!is_valid(pair, shape, shape) || !is_valid_motion(ray.motion)) return invalid_cast();
    const CastPath path = make_path(pair, ray.motion, ray.radius);
    return cast_result(clip_path(pair, path), path, pair.a, ray.radius, ray.position);
}

void miss(CastResult& result, int vertices) {
    result.status = CastStatus::miss;
    result.fraction = result.lower = result.upper = 1.0;
    result.iterations = vertices;
}

// The hit at `fraction`, known up to `doubt`; a miss if that is beyond the ray's end.
[[gnu::always_inline]] inline void enter(CastResult& result, int vertices, double fraction, double doubt, DVec2 normal,
                                         DVec2 point) {
    TUMBLE_CHECK(fraction >= 0.0);
    TUMBLE_CHECK(doubt >= 0.0);
    if (fraction - doubt > 1.0) return miss(result, vertices);
    result.status = CastStatus::hit;
    result.fraction = std::min(fraction, 1.0);
    result.lower = std::max(0.0, fraction - doubt);
    result.upper = fraction + doubt;
    TUMBLE_CHECK(result.lower <= result.fraction);
    result.point.x = point.x;
    result.point.y = point.y;
    result.normal.x = normal.x;
    result.normal.y = normal.y;
    result.iterations = vertices;
}

// The quadratic |m - t v|^2 = r^2 for the centre m, and the radius r known to 2 E: with (r + 2 E)^2 - r^2 <= D the root
// of the discriminant h is known to D |v|^2 / h, as sqrt(1 - x) >= 1 - x. A function of its own, which needs no memory
// but the result.
[[gnu::noinline]] CastResult cast_at_circle(const Shape& shape, const Pose& world_from_shape, DVec2 origin, DVec2 v) {
    TUMBLE_CHECK(shape.vertex_count() == 1);
    const Ray ray = make_ray(shape, world_from_shape, origin, v);
    const DVec2 on_core = ray.core.point(0), center = on_core - ray.offset;
    const double radius = ray.radius, radius_sq = radius * radius, doubt_sq = 4.0 * ray.error * (radius + ray.error);
    const double ahead = dot(v, center), aside = cross(v, center), margin = doubt_sq * ray.motion_sq;
    const double discriminant = radius_sq * ray.motion_sq - aside * aside;
    const bool is_outside = length_sq(center) - radius_sq > doubt_sq && radius > 16.0 * ray.error;
    if (!is_moderate(ray.motion_sq, ray.scale) || !is_outside)
        return cast_in_general(shape, world_from_shape, origin, v);
    if (ahead <= 0.0 || discriminant < -margin) return missed(1);
    if (!(discriminant > 4.0 * margin)) return cast_in_general(shape, world_from_shape, origin, v);
    const double root = std::sqrt(discriminant), both = 1.0 / (radius * ray.motion_sq), inverse = both * radius;
    const double fraction = (ahead - root) * inverse, doubt = doubt_sq / root + ray.error * ray.path * inverse;
    TUMBLE_CHECK(fraction >= 0.0);
    TUMBLE_CHECK(doubt >= 0.0);
    if (fraction - doubt > 1.0) return missed(1);
    const DVec2 normal = -both * (root * v + aside * perp(v));
    const DVec2 point = ray.position + (on_core + radius * normal);
    return {CastStatus::hit,
            std::min(fraction, 1.0),
            std::max(0.0, fraction - doubt),
            fraction + doubt,
            point,
            normal,
            1,
            false};
}

// The coordinates of each vertex across and along the ray, a vertex a lane; both times |v| |q|^2. In the shape's own
// axes, scaled by |q|^2, where the vertices need no rotation.
template <int N>
struct RayVertices {
    double scale;  // |q|^2
    DoubleLanes<N> side;
    DoubleLanes<N> ahead;
};

template <int N>
TUMBLE_LANE_FUNCTION RayVertices<N> project(const Core& core, DVec2 offset, DVec2 motion) {
    TUMBLE_CHECK(core.count >= 2);
    TUMBLE_CHECK(core.count <= N);
    const double scale = core.c * core.c + core.s * core.s;
    const DVec2 o = core.turned_back(offset), v = core.turned_back(motion);
    const DoubleLanes<N> x = scale * load_widened<N>(core.x) - DoubleLanes<N>(o.x),
                         y = scale * load_widened<N>(core.y) - DoubleLanes<N>(o.y);
    return {scale, v.x * y - v.y * x, v.x * x + v.y * y};
}

// The point at which the line crosses the face between two vertices; clear if both ends are off the line by a margin.
struct Crossing {
    double inverse;  // 1 / the distance of the ends across the line
    double along;    // 0 at the first vertex, 1 at the second
    double ahead;
    bool is_clear;
};

template <int N>
TUMBLE_LANE_FUNCTION Crossing cross_face(const RayVertices<N>& vertices, int from, int to, double margin) {
    const double side_from = vertices.side[from], side_to = vertices.side[to], inverse = 1.0 / (side_from - side_to);
    const double along = side_from * inverse;
    return {inverse, along, vertices.ahead[from] + along * (vertices.ahead[to] - vertices.ahead[from]),
            std::min(std::abs(side_from), std::abs(side_to)) >= margin};
}

// The line enters through the face that runs from its left to its right, and leaves through the other one that crosses
// it. A segment has two faces, one on each side.
template <int N>
[[gnu::always_inline]] inline bool cast_at_sharp_polygon(const Ray& ray, CastResult& result) {
    const Core& core = ray.core;
    const RayVertices<N> vertices = project<N>(core, ray.offset, ray.motion);
    const auto count = static_cast<unsigned>(core.count), all = (1u << count) - 1u;
    const unsigned left = ~bits_of(vertices.side < DoubleLanes<N>(0.0)) & all,
                   next_left = ((left >> 1) | (left << (count - 1u))) & all;
    const unsigned entries = left & ~next_left, exits = ~left & next_left;
    const double margin = 2.0 * ray.error * ray.path * vertices.scale;
    if (entries == 0) {
        if (!(smallest(larger(vertices.side, DoubleLanes<N>(0.0) - vertices.side)) > margin)) return false;
        miss(result, core.count);
        return true;
    }
    if (!std::has_single_bit(entries)) return false;
    TUMBLE_CHECK(exits != 0u);
    const int from = std::countr_zero(entries), to = core.next(from);
    const int exit_from = std::countr_zero(exits);
    TUMBLE_CHECK(from < core.count);
    TUMBLE_CHECK(exit_from < core.count);
    TUMBLE_CHECK(exit_from != from);
    const Crossing entry = cross_face(vertices, from, to, margin),
                   exit = cross_face(vertices, exit_from, core.next(exit_from), margin);
    if (!entry.is_clear || !exit.is_clear) return false;
    if (exit.ahead < -margin) {
        miss(result, core.count);
        return true;
    }
    const DVec2 edge = core.edge(from, to);
    const double edge_length = length(edge), inverse_length = 1.0 / edge_length;
    // The ends lie |e| s |q|^2 apart across the line where the face closes at the rate s. The start is then
    // fraction / doubt times E outside of the face.
    const double fraction = entry.ahead / (vertices.scale * ray.motion_sq);
    const double doubt = ray.error * edge_length * vertices.scale * entry.inverse;
    if (!(fraction > 2.0 * doubt)) return false;
    enter(result, core.count, fraction, doubt, inverse_length * -perp(edge),
          ray.position + (core.point(from) + entry.along * edge));
    return true;
}

[[gnu::always_inline]] inline bool cast_at_clear(const Ray& ray, CastResult& result) {
    const int count = ray.core.count;
    if (!is_moderate(ray.motion_sq, ray.scale)) return false;
    if (ray.radius != 0.0 || count < 2 || count > Shape::kInlineVertices) return false;
    return count <= 4 ? cast_at_sharp_polygon<4>(ray, result) : cast_at_sharp_polygon<8>(ray, result);
}

[[gnu::noinline]] CastResult cast_at_cores(const Shape& shape, const Pose& world_from_shape, DVec2 origin,
                                           DVec2 translation) {
    // One result for all returns: a second one would be copied.
    CastResult result;
    const bool is_clear = cast_at_clear(make_ray(shape, world_from_shape, origin, translation), result);
    if (!is_clear) result = cast_in_general(shape, world_from_shape, origin, translation);
    return result;
}

}  // namespace

CastResult cast_ray(const Shape& shape, const Pose& world_from_shape, DVec2 origin, DVec2 translation) noexcept {
    return shape.vertex_count() == 1 ? cast_at_circle(shape, world_from_shape, origin, translation)
                                     : cast_at_cores(shape, world_from_shape, origin, translation);
}

}  // namespace tumble
