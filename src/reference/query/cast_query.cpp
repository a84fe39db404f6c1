#include "reference/query/cast_query.hpp"

namespace tumble::reference {

CastResult query_tumble(const CastQuery& query) {
    switch (query.kind) {
        case CastKind::ray: return cast_ray(query.a, query.pose_a, query.pose_b.position, query.translation);
        case CastKind::shape:
            return cast_shape(query.a, query.pose_a, query.b, query.pose_b, query.translation, query.target);
        case CastKind::impact: return time_of_impact(query.a, query.sweep_a, query.b, query.sweep_b, query.target);
    }
    return {};
}

PairQuery start_of(const CastQuery& query) {
    if (query.kind != CastKind::impact) return {query.a, query.b, query.pose_a, query.pose_b};
    return {query.a, query.b, pose_at(query.sweep_a, 0.0), pose_at(query.sweep_b, 0.0)};
}

}  // namespace tumble::reference
