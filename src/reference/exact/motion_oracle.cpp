#include "reference/exact/motion_oracle.hpp"

#include <algorithm>
#include <cmath>

#include "debug/check.hpp"
namespace tumble::reference {

namespace {

using brute::cross;
using brute::dot;
using brute::norm;
using brute::Point;
using Real = brute::Real;

constexpr Real kUnit = 0x1p-53L;

Point between(DVec2 from, DVec2 to) { return {static_cast<Real>(to.x) - from.x, static_cast<Real>(to.y) - from.y}; }

// The fraction at which a point that moves from the origin by `displacement` enters the circle of radius `reach` about
// `center`, if it does.
std::optional<Real> enter_circle(Point center, Point displacement, Real reach) {
    const Real length_sq = dot(displacement, displacement), ahead = dot(displacement, center),
               aside = cross(displacement, center);
    const Real rest = reach * reach * length_sq - aside * aside;
    if (rest < 0 || ahead <= 0) return std::nullopt;
    return (ahead - std::sqrt(rest)) / length_sq;
}

// The fraction at which such a point crosses the segment.
std::optional<Real> cross_segment(Point from, Point to, Point displacement) {
    const Point edge = to - from;
    const Real det = cross(displacement, edge);
    if (det == 0) return std::nullopt;
    const Real along = cross(from, displacement) / det;
    if (along < 0 || along > 1) return std::nullopt;
    return cross(from, edge) / det;
}

}  // namespace

std::vector<Point> MotionOracle::Body::at(Real fraction) const {
    const Real c = std::cos(angle + fraction * turn), s = std::sin(angle + fraction * turn);
    const Point center = start + fraction * displacement;
    std::vector<Point> moved;
    moved.reserve(vertices.size());
    for (const Point v : vertices)
        moved.push_back(turn == 0 ? center + v : center + Point{c * v.x - s * v.y, s * v.x + c * v.y});
    return moved;
}

MotionOracle::Body MotionOracle::body_of(const Shape& shape, const Pose& pose, DVec2 origin) {
    Body body;
    body.vertices = brute::world_vertices(shape, pose, pose.position);
    body.start = between(origin, pose.position);
    body.extent = shape.core_radius();
    return body;
}

// The vertices of a body that does not turn are rotated here, once.
MotionOracle::Body MotionOracle::body_of(const Shape& shape, const Sweep& sweep, DVec2 origin) {
    Body body;
    body.angle = sweep.start_angle;
    body.turn = sweep.turn;
    body.start = between(origin, sweep.start);
    body.displacement = between(sweep.start, sweep.end);
    const Real c = std::cos(body.angle), s = std::sin(body.angle);
    for (int i = 0; i < shape.vertex_count(); ++i) {
        const Point v{static_cast<Real>(shape.vertex(i).x) - sweep.local_center.x,
                      static_cast<Real>(shape.vertex(i).y) - sweep.local_center.y};
        body.vertices.push_back(body.turn == 0 ? Point{c * v.x - s * v.y, s * v.x + c * v.y} : v);
    }
    body.extent = shape.core_radius() + length(DVec2(sweep.local_center));
    return body;
}

// E: for a translation 16 u times the sum of sizes, offset and reach, as the narrow phase derives it. For a time of
// impact 24 u times the sum of sizes, offset and displacements, plus 4 u times the angles times their levers, plus 16 u
// times the reach. The sum of all worst cases in the narrow phase is larger than this.
MotionOracle::MotionOracle(const CastQuery& query) {
    const Real radii = static_cast<Real>(query.a.radius()) + query.b.radius();
    reach_ = radii + query.target;
    if (query.kind == CastKind::impact) {
        a_ = body_of(query.a, query.sweep_a, query.sweep_a.start);
        b_ = body_of(query.b, query.sweep_b, query.sweep_a.start);
    } else {
        a_ = body_of(query.a, query.pose_a, query.pose_a.position);
        b_ = body_of(query.b, query.pose_b, query.pose_a.position);
        b_.displacement = {query.translation.x, query.translation.y};
    }
    const Real sizes = a_.extent + b_.extent + norm(b_.start);
    const Real levers =
        (std::abs(a_.angle) + std::abs(a_.turn)) * a_.extent + (std::abs(b_.angle) + std::abs(b_.turn)) * b_.extent;
    error_ = static_cast<double>(
        query.kind == CastKind::impact
            ? kUnit * (24 * (sizes + norm(a_.displacement) + norm(b_.displacement)) + 4 * levers + 16 * reach_)
            : kUnit * 16 * (sizes + reach_));
    speed_ = norm(b_.displacement - a_.displacement) + std::abs(a_.turn) * a_.extent + std::abs(b_.turn) * b_.extent;
}

Real MotionOracle::gap(Real fraction) const { return brute::core_distance(a_.at(fraction), b_.at(fraction)) - reach_; }

// The first fraction after `from` at which the cores are within the reach; they must be apart by more at `from`.
// Positions within the reach are bounded by the circles about the vertices and by the edges offset by the reach, so
// that the first crossing of one of these is the answer.
std::optional<Real> MotionOracle::first_within(Real reach, Real from) const {
    const Point displacement = b_.displacement - a_.displacement;
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
    offer_edges(b, a, displacement);
    offer_edges(a, b, Real{-1} * displacement);
    if (reach > 0)
        for (const Point p : a)
            for (const Point q : b) offer(enter_circle(p - q, displacement, reach));
    return first ? std::optional<Real>(from + *first) : std::nullopt;
}

bool MotionOracle::stays_above(Real floor, Real from, Real to) const {
    if (!is_straight()) return stays_above_by_speed(floor, from, to);
    if (gap(from) < floor || gap(to) < floor) return false;
    const Real reach = reach_ + floor;
    const std::optional<Real> first = first_within(std::max(reach, Real{0}), from);
    if (!first || *first >= to) return true;
    return reach < 0 && smallest_gap(*first, to) >= floor;  // cores without radii may overlap by up to -floor
}

// Along a translation the signed distance is convex: ternary search, to 2^-60 of the motion.
Real MotionOracle::smallest_gap(Real from, Real to) const {
    TUMBLE_CHECK(from <= to);
    for (int i = 0; i < 104; ++i) {
        const Real left = (2 * from + to) / 3, right = (from + 2 * to) / 3;
        const bool is_left_lower = gap(left) < gap(right);
        (is_left_lower ? to : from) = is_left_lower ? right : left;
    }
    return std::min(gap(from), gap(to));
}

bool MotionOracle::stays_above_by_speed(Real floor, Real from, Real to) const {
    TUMBLE_CHECK(from <= to);
    const Real middle = (from + to) / 2, there = gap(middle);
    if (there < floor) return false;
    if (there - speed_ * (to - from) / 2 >= floor) return true;
    return stays_above_by_speed(floor, from, middle) && stays_above_by_speed(floor, middle, to);
}

}  // namespace tumble::reference
