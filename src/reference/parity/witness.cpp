#include "reference/parity/witness.hpp"

#include <algorithm>
#include <cmath>

namespace tumble::reference {

namespace {

double segment_distance_sq(DVec2 from, DVec2 to) {
    const DVec2 edge = to - from;
    const double edge_sq = length_sq(edge);
    const double t = edge_sq > 0.0 ? std::clamp(-dot(from, edge) / edge_sq, 0.0, 1.0) : 0.0;
    return length_sq(from + t * edge);
}

// Like std::max, but NaN if either is NaN.
double larger(double a, double b) { return a > b || std::isnan(a) ? a : b; }

}  // namespace

double surface_distance(const Shape& shape, const Pose& world_from_shape, DVec2 point) {
    const DVec2 offset = world_from_shape.position - point;
    const auto vertex = [&](int i) { return rotate(world_from_shape.rotation, DVec2(shape.vertex(i))) + offset; };
    const int count = shape.vertex_count();
    double nearest_sq = INFINITY;
    bool inside = count > 2;
    DVec2 from = vertex(count - 1);
    for (int i = 0; i < count; ++i) {
        const DVec2 to = vertex(i);
        nearest_sq = std::min(nearest_sq, segment_distance_sq(from, to));
        inside = inside && cross(from, to) > 0.0;
        from = to;
    }
    const double from_core = inside ? -std::sqrt(nearest_sq) : std::sqrt(nearest_sq);
    return std::abs(from_core - shape.radius());
}

double witness_error(const PairQuery& query, const DistanceResult& result) {
    const DVec2 rest = result.point_b - result.point_a - result.distance * result.normal;
    return larger(larger(surface_distance(query.a, query.pose_a, result.point_a),
                         surface_distance(query.b, query.pose_b, result.point_b)),
                  length(rest));
}

double witness_error(const PairQuery& query, const B2Distance& result) {
    const double apart = length(result.point_b - result.point_a);
    return larger(larger(surface_distance(query.a, query.pose_a, result.point_a),
                         surface_distance(query.b, query.pose_b, result.point_b)),
                  std::abs(apart - result.distance));
}

}  // namespace tumble::reference
