#include "reference/exact/interval_pair.hpp"

#include <algorithm>
#include <cmath>

#include "reference/exact/support_follower.hpp"

namespace tumble::reference {

namespace {

using brute::cross;
using brute::dot;
using brute::norm;
using brute::Point;
using brute::Real;

constexpr Real kErrorFactor = 32;
constexpr Real kSideFactor = 16;         // of the sign of d x e
constexpr Real kLargestRatio = 1 << 20;  // of two edges to their difference: its terms of second order are small
constexpr Real kInfinity = std::numeric_limits<Real>::infinity();

void set_long_dot(Real& target, const Point& p, const Point& q) { target = dot(p, q); }

using LongFollower = MinkowskiFollower<Point, Real, set_long_dot>;

Real largest_norm(const std::vector<Point>& points) {
    Real largest_sq = 0;
    for (const Point p : points) largest_sq = std::max(largest_sq, dot(p, p));
    return std::sqrt(largest_sq);
}

// From one vertex to another in world axes, to a relative error of 4.25 u however short it is.
Point turned_edge(const Shape& shape, Rotation q, std::size_t from, std::size_t to) {
    const Real x = Real{shape.x()[to]} - shape.x()[from], y = Real{shape.y()[to]} - shape.y()[from];
    return {q.c * x - q.s * y, q.s * x + q.c * y};
}

std::size_t next_of(std::size_t i, std::size_t count) { return i + 1 == count ? 0 : i + 1; }

VertexPair vertex_pair(std::size_t a, std::size_t b) {
    return {static_cast<std::uint16_t>(a), static_cast<std::uint16_t>(b)};
}

}  // namespace

IntervalPair::IntervalPair(const PairQuery& query, Arithmetic arithmetic)
    : query_(query),
      a_(brute::world_vertices(query.a, query.pose_a, query.pose_a.position)),
      b_(brute::world_vertices(query.b, query.pose_b, query.pose_b.position)) {
    const DVec2 from = query.pose_a.position, to = query.pose_b.position;
    const Point offset{Real{to.x} - from.x, Real{to.y} - from.y};
    const Real scale = largest_norm(a_) + largest_norm(b_) + norm(offset);
    const bool may_decide = arithmetic == Arithmetic::intervals_first && query.a.is_convex() && query.b.is_convex();
    error_ = may_decide ? kErrorFactor * kLongRoundoff * scale : kInfinity;
    for (Point& p : b_) p = p + offset;
}

Interval IntervalPair::separation(DVec2 direction) const {
    const Point d{direction.x, direction.y};
    return interval_about(-LongFollower(a_, b_).support_value(d) / norm(d), error_);
}

Interval IntervalPair::segment_distance(VertexPair from, VertexPair to) const {
    return interval_about(brute::distance_to_segment({}, vertex(from), vertex(to)), error_);
}

Interval IntervalPair::face_separation(VertexPair from, VertexPair to, DVec2 direction) const {
    const Point w = vertex(from), d{direction.x, direction.y};
    if (from == to) return interval_about(-norm(w), error_);
    const Point edge_a = turned_edge(query_.a, query_.pose_a.rotation, from.a, to.a);
    const Point edge_b = turned_edge(query_.b, query_.pose_b.rotation, from.b, to.b);
    const Point edge = edge_a - edge_b;
    const Real length = norm(edge), lengths = norm(edge_a) + norm(edge_b);
    if (!(kLargestRatio * length > lengths)) return {};
    const Real along = cross(d, edge);
    if (!(std::abs(along) > kSideFactor * kLongRoundoff * norm(d) * lengths)) return {};
    const Real value = cross(edge, w) / length;
    return interval_about(along < 0 ? -value : value, error_ * lengths / length);
}

std::vector<EstimatedFace> IntervalPair::faces() const {
    std::vector<EstimatedFace> faces;
    faces.reserve(a_.size() + b_.size());
    add_faces(faces, true);
    if (!faces.empty() && faces.back().separation.low > 0) return faces;
    add_faces(faces, false);
    return faces;
}

void IntervalPair::add_faces(std::vector<EstimatedFace>& faces, bool is_of_a) const {
    const Shape& shape = is_of_a ? query_.a : query_.b;
    const Rotation rotation = is_of_a ? query_.pose_a.rotation : query_.pose_b.rotation;
    const std::size_t count = is_of_a ? a_.size() : b_.size();
    const Real side = is_of_a ? 1 : -1;  // outward for A, inward for B, since B enters negated
    const bool is_searched = a_.size() <= kSearchAll && b_.size() <= kSearchAll;
    LongFollower follower(a_, b_);
    for (std::size_t i = 0; i < count; ++i) {
        const Point edge = turned_edge(shape, rotation, i, next_of(i, count));
        const Real length = norm(edge);
        if (length == 0) continue;
        const Real value = -follower.support_value({side * edge.y, -side * edge.x}) / length;
        faces.push_back({is_of_a, i, {is_searched ? value - error_ : -kInfinity, value + error_}});
        if (faces.back().separation.low > 0) return;
    }
}

std::vector<EstimatedSegment> IntervalPair::segments() const {
    std::vector<EstimatedSegment> segments;
    Real nearest = kInfinity;
    const auto add = [&](VertexPair from, VertexPair to, Real distance) {
        if (distance - error_ > nearest) return;
        nearest = std::min(nearest, distance + error_);
        segments.push_back({from, to, interval_about(distance, error_)});
    };
    const std::size_t n = a_.size(), m = b_.size();
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < m; ++j) {
            const std::size_t next_i = next_of(i, n), next_j = next_of(j, m);
            const VertexPair here = vertex_pair(i, j);
            add(here, vertex_pair(i, next_j), brute::distance_to_segment(a_[i], b_[j], b_[next_j]));
            if (next_i == i) continue;
            add(here, vertex_pair(next_i, j), brute::distance_to_segment(b_[j], a_[i], a_[next_i]));
        }
    }
    return segments;
}

}  // namespace tumble::reference
