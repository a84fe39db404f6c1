#include "reference/exact/true_motion.hpp"

#include <algorithm>
#include <cmath>

namespace tumble::reference {

namespace {

using brute::cross;
using brute::dot;
using brute::norm;
using brute::Point;
using Real = brute::Real;

constexpr Real kUnit = 0x1p-53L;

Point between(DVec2 from, DVec2 to) { return {static_cast<Real>(to.x) - from.x, static_cast<Real>(to.y) - from.y}; }

// When a point that moves from the origin by `way` is first at the distance `reach` from `center`, from outside.
std::optional<Real> enter_circle(Point center, Point way, Real reach) {
    const Real length_sq = dot(way, way), ahead = dot(way, center), aside = cross(way, center);
    const Real rest = reach * reach * length_sq - aside * aside;
    if (rest < 0 || ahead <= 0) return std::nullopt;
    return (ahead - std::sqrt(rest)) / length_sq;
}

// ... and when it first crosses the segment.
std::optional<Real> cross_segment(Point from, Point to, Point way) {
    const Point edge = to - from;
    const Real det = cross(way, edge);
    if (det == 0) return std::nullopt;
    const Real along = cross(from, way) / det;
    if (along < 0 || along > 1) return std::nullopt;
    return cross(from, edge) / det;
}

}  // namespace

std::vector<Point> TrueMotion::Body::at(Real fraction) const {
    const Real c = std::cos(angle + fraction * turn), s = std::sin(angle + fraction * turn);
    const Point center = start + fraction * way;
    std::vector<Point> moved;
    moved.reserve(vertices.size());
    for (const Point v : vertices)
        moved.push_back(turn == 0 ? center + v : center + Point{c * v.x - s * v.y, s * v.x + c * v.y});
    return moved;
}

TrueMotion::Body TrueMotion::body_of(const Shape& shape, const Pose& pose, DVec2 origin) {
    Body body;
    body.vertices = brute::world_vertices(shape, pose, pose.position);
    body.start = between(origin, pose.position);
    body.extent = shape.core_radius();
    return body;
}

// Without a turn the vertices are turned here, once.
TrueMotion::Body TrueMotion::body_of(const Shape& shape, const Sweep& sweep, DVec2 origin) {
    Body body;
    body.angle = sweep.start_angle;
    body.turn = sweep.turn;
    body.start = between(origin, sweep.start);
    body.way = between(sweep.start, sweep.end);
    const Real c = std::cos(body.angle), s = std::sin(body.angle);
    for (int i = 0; i < shape.vertex_count(); ++i) {
        const Point v{static_cast<Real>(shape.vertex(i).x) - sweep.local_center.x,
                      static_cast<Real>(shape.vertex(i).y) - sweep.local_center.y};
        body.vertices.push_back(body.turn == 0 ? Point{c * v.x - s * v.y, s * v.x + c * v.y} : v);
    }
    body.extent = shape.core_radius() + length(DVec2(sweep.local_center));
    return body;
}

// E: 16 u of the sizes, the offset and the reach for a translation, as the narrow phase derives it; for a time of
// impact 24 u of the sizes, the offset and the ways, which is less than its worst cases add up to, and 4 u of the
// angles times the levers.
TrueMotion::TrueMotion(const CastQuery& query) {
    const Real radii = static_cast<Real>(query.a.radius()) + query.b.radius();
    reach_ = radii + query.target;
    if (query.kind == CastKind::impact) {
        a_ = body_of(query.a, query.sweep_a, query.sweep_a.start);
        b_ = body_of(query.b, query.sweep_b, query.sweep_a.start);
    } else {
        a_ = body_of(query.a, query.pose_a, query.pose_a.position);
        b_ = body_of(query.b, query.pose_b, query.pose_a.position);
        b_.way = {query.translation.x, query.translation.y};
    }
    const Real sizes = a_.extent + b_.extent + norm(b_.start);
    const Real levers =
        (std::abs(a_.angle) + std::abs(a_.turn)) * a_.extent + (std::abs(b_.angle) + std::abs(b_.turn)) * b_.extent;
    error_ = static_cast<double>(query.kind == CastKind::impact
                                     ? kUnit * (24 * (sizes + norm(a_.way) + norm(b_.way)) + 4 * levers + 16 * reach_)
                                     : kUnit * 16 * (sizes + reach_));
    speed_ = norm(b_.way - a_.way) + std::abs(a_.turn) * a_.extent + std::abs(b_.turn) * b_.extent;
}

Real TrueMotion::gap(Real fraction) const { return brute::core_distance(a_.at(fraction), b_.at(fraction)) - reach_; }

// The first fraction after `from` at which the cores are within the reach, outside of which they start: the boundary of
// all places within it is made of the vertices' circles and the edges moved by it, and none of these lies outside.
std::optional<Real> TrueMotion::first_within(Real reach, Real from) const {
    const Point way = b_.way - a_.way;
    const std::vector<Point> a = a_.at(from), b = b_.at(from);
    std::optional<Real> first;
    const auto offer = [&first](std::optional<Real> fraction) {
        if (fraction && *fraction >= 0 && (!first || *fraction < *first)) first = fraction;
    };
    const auto offer_edges = [&](const std::vector<Point>& points, const std::vector<Point>& outline, Point motion) {
        for (const Point point : points)
            for (std::size_t i = 0; i < outline.size(); ++i) {
                const Point p = outline[i] - point, q = outline[(i + 1) % outline.size()] - point, edge = q - p;
                const Real length_of_edge = norm(edge);
                if (length_of_edge == 0) continue;
                const Point aside = (reach / length_of_edge) * Point{edge.y, -edge.x};
                offer(cross_segment(p + aside, q + aside, motion));
                offer(cross_segment(p - aside, q - aside, motion));
            }
    };
    offer_edges(b, a, way);
    offer_edges(a, b, Real{-1} * way);
    if (reach > 0)
        for (const Point p : a)
            for (const Point q : b) offer(enter_circle(p - q, way, reach));
    return first ? std::optional<Real>(from + *first) : std::nullopt;
}

bool TrueMotion::stays_above(Real floor, Real from, Real to) const {
    if (!is_straight()) return stays_above_by_speed(floor, from, to);
    if (gap(from) < floor || gap(to) < floor) return false;
    const Real reach = reach_ + floor;
    const std::optional<Real> first = first_within(std::max(reach, Real{0}), from);
    if (!first || *first >= to) return true;
    return reach < 0 && smallest_gap(*first, to) >= floor;  // sharp cores may overlap by less than that
}

// Along a translation the signed distance is convex: by thirds, to 2^-60 of the way.
Real TrueMotion::smallest_gap(Real from, Real to) const {
    for (int i = 0; i < 104; ++i) {
        const Real left = (2 * from + to) / 3, right = (from + 2 * to) / 3;
        const bool is_left_lower = gap(left) < gap(right);
        (is_left_lower ? to : from) = is_left_lower ? right : left;
    }
    return std::min(gap(from), gap(to));
}

bool TrueMotion::stays_above_by_speed(Real floor, Real from, Real to) const {
    const Real middle = (from + to) / 2, there = gap(middle);
    if (there < floor) return false;
    if (there - speed_ * (to - from) / 2 >= floor) return true;
    return stays_above_by_speed(floor, from, middle) && stays_above_by_speed(floor, middle, to);
}

}  // namespace tumble::reference
