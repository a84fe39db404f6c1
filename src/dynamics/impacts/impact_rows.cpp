#include "dynamics/impacts/impact_rows.hpp"

#include <algorithm>
#include <cmath>

#include "debug/check.hpp"

namespace tumble {

namespace {

// Two rows whose normals hardly differ in effect are solved one after the other.
constexpr double kLeastDeterminant = 1e-9;

// The velocity of B's point against A's along the normal.
double normal_speed(const ImpactPoint& point, const Twist& a, const Twist& b) {
    return speed_along(point.normal, cross(point.arm_a, point.normal), cross(point.arm_b, point.normal), a, b);
}

// What a unit impulse adds to the velocity of a body.
Twist push(const ImpactBody& body, DVec2 axis, double across) {
    return {{body.inv_mass.x * axis.x, body.inv_mass.y * axis.y}, body.inv_inertia * across};
}

ImpactDirection make_direction(const ImpactPoint& point, DVec2 axis, const ImpactBody& a, const ImpactBody& b) {
    ImpactDirection d;
    d.axis = axis;
    d.across_a = cross(point.arm_a, axis);
    d.across_b = cross(point.arm_b, axis);
    d.push_a = -1.0 * push(a, axis, d.across_a);
    d.push_b = push(b, axis, d.across_b);
    const double response = speed_along(axis, d.across_a, d.across_b, d.push_a, d.push_b);
    d.mass = response > point.least_response ? 1.0 / response : 0.0;
    return d;
}

bool bounces(const ImpactGroup& group, const ImpactPoint& point) {
    return can_bounce(point) && approach_at_impact(group, point) < -point.threshold;
}

// The part of its approach speed v with which a point leaves. Newton's law holds at the surface. A point that is found
// at another separation s leaves with the speed v' that a body which has bounced at the surface has there: under the
// relative acceleration a, v'^2 = e^2 (v^2 - 2 a s) + 2 a s.
double effective_restitution(const ImpactGroup& group, const ImpactPoint& point) {
    const ImpactBody &a = group.bodies[point.a], &b = group.bodies[point.b];
    const double speed = approach_at_impact(group, point), e = point.restitution;
    const double work = 2.0 * dot(b.acceleration - a.acceleration, point.normal) * point.separation;
    const double square = e * e * (speed * speed - work) + work;
    return std::clamp(std::sqrt(std::max(square, 0.0)) / -speed, 0.0, 1.0);
}

}  // namespace

double approach_at_impact(const ImpactGroup& group, const ImpactPoint& point) {
    TUMBLE_CHECK(point.a < group.bodies.size());
    TUMBLE_CHECK(point.b < group.bodies.size());
    const ImpactBody &a = group.bodies[point.a], &b = group.bodies[point.b];
    return normal_speed(point, a.velocity + a.change, b.velocity + b.change);
}

double approach_ahead(const ImpactGroup& group, const ImpactPoint& point) {
    const ImpactBody &a = group.bodies[point.a], &b = group.bodies[point.b];
    return normal_speed(point, a.mean_velocity + a.change + a.hold, b.mean_velocity + b.change + b.hold);
}

bool can_bounce(const ImpactPoint& point) { return point.restitution > 0.0 && point.bounce_count < kMaxBounces; }

ImpactRow make_row(const ImpactGroup& group, std::size_t index) {
    const ImpactPoint& point = group.points[index];
    const ImpactBody &a = group.bodies[point.a], &b = group.bodies[point.b];
    ImpactRow row;
    row.point = index;
    row.a = point.a;
    row.b = point.b;
    row.normal = make_direction(point, point.normal, a, b);
    row.normal.speed = speed_along(row.normal, a.velocity, b.velocity);
    row.tangent = make_direction(point, -perp(point.normal), a, b);
    row.tangent.speed = speed_along(row.tangent, a.velocity, b.velocity) + point.tangent_speed;
    row.friction = point.friction;
    if (row.normal.mass > 0.0 && row.tangent.mass > 0.0)
        row.tangent_coupling = speed_along(row.tangent, row.normal.push_a, row.normal.push_b);
    row.restitution = bounces(group, point) ? effective_restitution(group, point) : 0.0;
    return row;
}

ImpactRow make_hold_row(const ImpactGroup& group, std::size_t index) {
    const ImpactPoint& point = group.points[index];
    const ImpactBody &a = group.bodies[point.a], &b = group.bodies[point.b];
    ImpactRow row;
    row.point = index;
    row.a = point.a;
    row.b = point.b;
    row.normal = make_direction(point, point.normal, a, b);
    row.normal.speed = speed_along(row.normal, a.mean_velocity + a.change, b.mean_velocity + b.change);
    return row;
}

void pair_up(std::vector<ImpactRow>& rows, const std::vector<ImpactPoint>& points) {
    for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
        const ImpactPoint &first = points[rows[i].point], &second = points[rows[i + 1].point];
        if (first.a != second.a || first.b != second.b || first.normal != second.normal) continue;
        const ImpactDirection &d1 = rows[i].normal, &d2 = rows[i + 1].normal;
        if (d1.mass == 0.0 || d2.mass == 0.0) continue;
        rows[i].coupling = speed_along(d2, d1.push_a, d1.push_b);
        rows[i].is_paired = 1.0 - d1.mass * d2.mass * rows[i].coupling * rows[i].coupling > kLeastDeterminant;
        if (rows[i].is_paired) ++i;
    }
}

}  // namespace tumble
