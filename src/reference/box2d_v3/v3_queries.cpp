#include "reference/box2d_v3/v3_queries.hpp"

#include <algorithm>
#include <cmath>

namespace tumble::reference {

namespace {

namespace v3 = box2d_v3;

// Whether Box2D v3 accepts a rotation: the inverse of its pose is that of a rotation of unit length.
bool is_unit(Rotation q) {
    constexpr double kLargestError = 6.0 * 0x1p-23;
    return std::abs(double{q.c} * q.c + double{q.s} * q.s - 1.0) < kLargestError;
}

bool is_finite_place(const v3::Place& place) { return std::isfinite(place.x) && std::isfinite(place.y); }

B2Cast cast_of(const v3::Hit& hit) {
    return {hit.hits, hit.overlaps, double{hit.fraction}, 0.25 * double{v3::linear_slop()}};
}

// Box2D interpolates the two rotations, which differs from a constant angular velocity.
constexpr double kMostTurn = 0.25;  // rad, up to which the difference is below 1e-4 rad

std::optional<B2Cast> v3_impact(const CastQuery& query, const V3Points& a, const V3Points& b) {
    if (std::max(std::abs(query.sweep_a.turn), std::abs(query.sweep_b.turn)) > kMostTurn) return std::nullopt;
    return cast_of(v3::time_of_impact(a.get(), b.get(), v3_motion(query.sweep_a), v3_motion(query.sweep_b)));
}

// The radius with which a cast of bare cores ends at the target: Box2D subtracts its slop from the sum of the radii.
float radius_for(double target) {
    const double slop = double{v3::linear_slop()};
    return static_cast<float>(target > slop ? target + slop : 0.0);
}

std::optional<B2Cast> cast_v3_ray(const CastQuery& query, const V3Points& shape) {
    const bool is_circle = query.a.vertex_count() == 1;
    if (!is_circle && (query.a.vertex_count() < 3 || query.a.radius() > 0.0f)) return std::nullopt;
    const Vec2 origin = to_float(inverse_transform_point(query.pose_a, query.pose_b.position)),
               along = to_float(inverse_rotate(query.pose_a.rotation, query.translation));
    B2Cast cast = cast_of(v3::cast_ray(shape.get(), origin.x, origin.y, along.x, along.y));
    cast.tolerance = 0.0;
    return cast;
}

}  // namespace

bool has_box2d_v3() { return v3::version() != nullptr; }
std::string box2d_v3_version() { return has_box2d_v3() ? v3::version() : ""; }
std::string box2d_v3_build() { return TUMBLE_BOX2D_V3_BUILD; }

V3Points::V3Points(const Shape& shape, std::optional<float> radius) : radius_(radius.value_or(shape.radius())) {
    if (shape.vertex_count() > v3::kMostPoints) return;
    count_ = shape.vertex_count();
    float* next = xy_;
    for (int i = 0; i < count_; ++i) {
        *next++ = shape.vertex(i).x;
        *next++ = shape.vertex(i).y;
    }
}

v3::Motion v3_motion(const Sweep& sweep) {
    const auto place = [](DVec2 center, double angle) {
        const Rotation q = make_rotation(angle);
        return v3::Place{static_cast<float>(center.x), static_cast<float>(center.y), q.c, q.s};
    };
    return {sweep.local_center.x, sweep.local_center.y, place(sweep.start, sweep.start_angle),
            place(sweep.end, sweep.start_angle + sweep.turn)};
}

v3::Place relative_place(const Pose& a, const Pose& b) {
    const Vec2 offset = to_float(inverse_rotate(a.rotation, b.position - a.position));
    const double ca = a.rotation.c, sa = a.rotation.s, cb = b.rotation.c, sb = b.rotation.s;
    return {offset.x, offset.y, static_cast<float>(ca * cb + sa * sb), static_cast<float>(ca * sb - sa * cb)};
}

std::optional<B2Distance> b2_v3_distance(const PairQuery& query, bool use_radii) {
    const V3Points a(query.a), b(query.b);
    const v3::Place place = relative_place(query.pose_a, query.pose_b);
    if (!a.fits() || !b.fits() || !is_finite(query) || !is_finite_place(place)) return std::nullopt;
    if (!is_unit(query.pose_a.rotation) || !is_unit(query.pose_b.rotation)) return std::nullopt;
    const v3::Nearest found = v3::distance(a.get(), b.get(), place, use_radii);
    return B2Distance{double{found.distance}, transform_point(query.pose_a, DVec2{found.ax, found.ay}),
                      transform_point(query.pose_a, DVec2{found.bx, found.by}), found.iterations};
}

std::optional<B2Cast> query_box2d_v3(const CastQuery& query) {
    if (query.kind == CastKind::ray) {
        const V3Points shape(query.a);
        return shape.fits() ? cast_v3_ray(query, shape) : std::nullopt;
    }
    if (query.a.radius() > 0.0f || query.b.radius() > 0.0f || query.target != b2_target(query.kind))
        return std::nullopt;
    const V3Points a(query.a, radius_for(query.target)), b(query.b);
    if (!a.fits() || !b.fits()) return std::nullopt;
    if (query.kind == CastKind::impact) return v3_impact(query, a, b);
    const Vec2 along = to_float(inverse_rotate(query.pose_a.rotation, query.translation));
    return cast_of(v3::cast_shape(a.get(), b.get(), relative_place(query.pose_a, query.pose_b), along.x, along.y));
}

}  // namespace tumble::reference
