#include "reference/box2d/b2_cast.hpp"

#include <box2d/b2_circle_shape.h>
#include <box2d/b2_distance.h>
#include <box2d/b2_polygon_shape.h>
#include <box2d/b2_time_of_impact.h>

#include <array>

#include "debug/check.hpp"
#include "reference/box2d/b2_types.hpp"

namespace tumble::reference {

namespace {

struct Vertices {
    std::array<b2Vec2, Shape::kInlineVertices> at;
    int count;

    explicit Vertices(const Shape& shape) : count(shape.vertex_count()) {
        TUMBLE_CHECK(count <= Shape::kInlineVertices);
        for (int i = 0; i < count; ++i) at[static_cast<std::size_t>(i)] = to_b2(DVec2(shape.vertex(i)));
    }
    b2DistanceProxy proxy() const {
        b2DistanceProxy proxy;
        proxy.Set(at.data(), count, 0.0f);
        return proxy;
    }
};

// True for polygons that b2PolygonShape keeps unchanged. It welds vertices nearer than half its slop, and aborts the
// process if too few are left.
bool is_fit_for_b2(const Shape& polygon) {
    if (extent(polygon).smaller < 8.0f * b2_linearSlop) return false;
    for (int i = 0; i < polygon.vertex_count(); ++i)
        for (int j = 0; j < i; ++j)
            if (length(polygon.vertex(i) - polygon.vertex(j)) < b2_linearSlop) return false;
    return polygon.vertex_count() >= 3 && polygon.vertex_count() <= Shape::kInlineVertices && polygon.radius() == 0.0f;
}

std::optional<B2Cast> cast_b2_ray(const CastQuery& query) {
    const DVec2 origin = query.pose_b.position;
    const b2RayCastInput input{to_b2(origin), to_b2(origin + query.translation), 1.0f};
    const b2Transform pose = to_b2(query.pose_a);
    b2RayCastOutput output;
    bool hits = false;
    if (query.a.vertex_count() == 1) {
        b2CircleShape circle;
        circle.m_p = to_b2(DVec2(query.a.vertex(0)));
        circle.m_radius = query.a.radius();
        hits = circle.RayCast(&output, input, pose, 0);
    } else if (is_fit_for_b2(query.a)) {
        const Vertices vertices(query.a);
        b2PolygonShape polygon;
        polygon.Set(vertices.at.data(), vertices.count);
        hits = polygon.RayCast(&output, input, pose, 0);
    } else {
        return std::nullopt;
    }
    return B2Cast{hits, false, hits ? output.fraction : 1.0, 0.0};
}

B2Cast cast_b2_shape(const CastQuery& query) {
    const Vertices a(query.a), b(query.b);
    const b2ShapeCastInput input{a.proxy(), b.proxy(), to_b2(query.pose_a), to_b2(query.pose_b),
                                 to_b2(query.translation)};
    b2ShapeCastOutput output;
    const bool hits = b2ShapeCast(&output, &input);
    return {hits, false, hits ? output.lambda : 1.0, 0.5 * b2_linearSlop};
}

B2Cast find_b2_impact(const CastQuery& query) {
    const Vertices a(query.a), b(query.b);
    const b2TOIInput input{a.proxy(), b.proxy(), to_b2(query.sweep_a), to_b2(query.sweep_b), 1.0f};
    b2TOIOutput output;
    b2TimeOfImpact(&output, &input);
    return {output.state == b2TOIOutput::e_touching, output.state == b2TOIOutput::e_overlapped, output.t,
            0.25 * b2_linearSlop};
}

}  // namespace

double b2_target(CastKind kind) {
    return kind == CastKind::ray ? 0.0 : kind == CastKind::shape ? b2_polygonRadius : b2_linearSlop;
}

std::optional<B2Cast> query_box2d(const CastQuery& query) {
    if (query.kind == CastKind::ray) return cast_b2_ray(query);
    const bool is_bare = query.a.radius() == 0.0f && query.b.radius() == 0.0f;
    const bool is_small =
        query.a.vertex_count() <= Shape::kInlineVertices && query.b.vertex_count() <= Shape::kInlineVertices;
    if (!is_bare || !is_small || query.target != b2_target(query.kind)) return std::nullopt;
    return query.kind == CastKind::shape ? cast_b2_shape(query) : find_b2_impact(query);
}

}  // namespace tumble::reference
