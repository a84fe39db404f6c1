#include "dynamics/impacts/impact_group.hpp"

#include <algorithm>
#include <cmath>

#include "debug/check.hpp"

namespace tumble {

namespace {

// Relative to the fastest approach: below it a contact counts as not approached.
constexpr double kTolerance = 1e-6;

// A round ends when no sweep changes a speed by more than this part of the fastest approach. What inelastic impacts
// leave, the contact solver of the next step stops.
constexpr double kElasticTolerance = 1e-7, kInelasticTolerance = 1e-4;

// A hold that is not complete leaves an overlap to the next step.
constexpr int kMaxHoldSweeps = 50;

ImpactDirection direction(const ImpactPoint& point, DVec2 axis) {
    return {axis, cross(point.arm_a, axis), cross(point.arm_b, axis)};
}
ImpactDirection normal_of(const ImpactPoint& point) { return direction(point, point.normal); }
ImpactDirection tangent_of(const ImpactPoint& point) { return direction(point, -perp(point.normal)); }

double relative_speed(const ImpactDirection& d, const Twist& a, const Twist& b) {
    return dot(b.linear - a.linear, d.axis) + b.angular * d.across_b - a.angular * d.across_a;
}

DVec2 scaled(DVec2 factors, DVec2 v) { return {factors.x * v.x, factors.y * v.y}; }

// The change of the relative speed by a unit impulse, 1/kg.
double response(const ImpactDirection& d, const ImpactBody& a, const ImpactBody& b) {
    return dot(scaled(a.inv_mass + b.inv_mass, d.axis), d.axis) + a.inv_inertia * d.across_a * d.across_a +
           b.inv_inertia * d.across_b * d.across_b;
}

// Adds what an impulse does to the changes, or to the holds, of its bodies.
void apply(const ImpactDirection& d, double impulse, ImpactBody& a, ImpactBody& b, Twist ImpactBody::*target) {
    (a.*target).linear -= impulse * scaled(a.inv_mass, d.axis);
    (a.*target).angular -= impulse * a.inv_inertia * d.across_a;
    (b.*target).linear += impulse * scaled(b.inv_mass, d.axis);
    (b.*target).angular += impulse * b.inv_inertia * d.across_b;
}

double speed_at_impact(const ImpactDirection& d, const ImpactBody& a, const ImpactBody& b) {
    return relative_speed(d, a.velocity + a.change, b.velocity + b.change);
}
double speed_ahead(const ImpactDirection& d, const ImpactBody& a, const ImpactBody& b) {
    return relative_speed(d, a.mean_velocity + a.change + a.hold, b.mean_velocity + b.change + b.hold);
}

bool can_bounce(const ImpactPoint& point) { return point.restitution > 0.0 && point.bounce_count < kMaxBounces; }

bool bounces(const ImpactGroup& group, const ImpactPoint& point) {
    const ImpactBody &a = group.bodies[point.a], &b = group.bodies[point.b];
    return can_bounce(point) && speed_at_impact(normal_of(point), a, b) < -point.threshold;
}

// The part of its approach speed v with which a point leaves. Newton's law holds at the surface. A point that is found
// at another separation s leaves with the speed v' that a body which has bounced at the surface has there: under the
// relative acceleration a, v'^2 = e^2 (v^2 - 2 a s) + 2 a s.
double effective_restitution(const ImpactGroup& group, const ImpactPoint& point) {
    const ImpactBody &a = group.bodies[point.a], &b = group.bodies[point.b];
    const double speed = speed_at_impact(normal_of(point), a, b), e = point.restitution;
    const double work = 2.0 * dot(b.acceleration - a.acceleration, point.normal) * point.separation;
    const double square = e * e * (speed * speed - work) + work;
    return std::clamp(std::sqrt(std::max(square, 0.0)) / -speed, 0.0, 1.0);
}

ImpactRow make_row(const ImpactGroup& group, std::size_t index) {
    const ImpactPoint& point = group.points[index];
    const ImpactBody &a = group.bodies[point.a], &b = group.bodies[point.b];
    ImpactRow row;
    row.point = index;
    row.normal = normal_of(point);
    row.tangent = tangent_of(point);
    const double normal = response(row.normal, a, b), tangent = response(row.tangent, a, b);
    row.normal_mass = normal > point.least_response ? 1.0 / normal : 0.0;
    row.tangent_mass = tangent > point.least_response ? 1.0 / tangent : 0.0;
    row.restitution = bounces(group, point) ? effective_restitution(group, point) : 0.0;
    return row;
}

double kinetic_energy(const ImpactBody& body) {
    const Twist velocity = body.velocity + body.change;
    double energy = 0.0;
    if (body.inv_mass.x > 0.0) energy += 0.5 * velocity.linear.x * velocity.linear.x / body.inv_mass.x;
    if (body.inv_mass.y > 0.0) energy += 0.5 * velocity.linear.y * velocity.linear.y / body.inv_mass.y;
    if (body.inv_inertia > 0.0) energy += 0.5 * velocity.angular * velocity.angular / body.inv_inertia;
    return energy;
}

double kinetic_energy(const ImpactGroup& group) {
    double energy = 0.0;
    for (const ImpactBody& body : group.bodies) energy += kinetic_energy(body);
    return energy;
}

class ImpactRounds {
public:
    explicit ImpactRounds(ImpactGroup& group) : group_(group) {
        for (const ImpactPoint& point : group.points) {
            fastest_ = std::max({fastest_, -approach_at_impact(group, point), -approach_ahead(group, point)});
            if (point.restitution > 0.0) tolerance_ = kElasticTolerance;
        }
    }

    void run() {
        do {
            begin_round();
            const double energy = kinetic_energy(group_);
            while (sweep() > tolerance_ * fastest_ && work_ < kMaxImpactWork) {
            }
            bounce(energy);
        } while (work_ < kMaxImpactWork && has_impact());
        hold();
        for (ImpactBody& body : group_.bodies) drop_rounding(body);
    }

private:
    bool is_approached(const ImpactPoint& point, double least) const {
        return approach_at_impact(group_, point) < -std::max(2.0 * kTolerance * fastest_, least);
    }

    // Chooses the rows of a round.
    void begin_round() {
        group_.rows.clear();
        for (std::size_t i = 0; i < group_.points.size(); ++i)
            if (!can_bounce(group_.points[i]) || is_approached(group_.points[i], 0.0))
                group_.rows.push_back(make_row(group_, i));
    }

    bool has_impact() const {
        return std::any_of(group_.points.begin(), group_.points.end(),
                           [&](const ImpactPoint& point) { return is_approached(point, point.threshold); });
    }

    // One pass of projected Gauss-Seidel over the rows. Returns the largest change of a relative speed, m/s.
    double sweep() {
        work_ += static_cast<int>(group_.rows.size());
        double largest = 0.0;
        for (ImpactRow& row : group_.rows) {
            largest = std::max(largest, solve_normal(row));
            largest = std::max(largest, solve_tangent(row));
        }
        return largest;
    }

    // A box that lands flat leaves without spin.
    void drop_rounding(ImpactBody& body) const {
        const double least = kTolerance * fastest_;
        if (std::abs(body.change.linear.x) < least) body.change.linear.x = 0.0;
        if (std::abs(body.change.linear.y) < least) body.change.linear.y = 0.0;
        if (std::abs(body.change.angular) * body.reach < least) body.change.angular = 0.0;
    }

    ImpactPoint& point(const ImpactRow& row) { return group_.points[row.point]; }

    double speed(const ImpactRow& row, const ImpactDirection& d) {
        return speed_at_impact(d, group_.bodies[point(row).a], group_.bodies[point(row).b]);
    }

    void push(const ImpactRow& row, const ImpactDirection& d, double impulse) {
        apply(d, impulse, group_.bodies[point(row).a], group_.bodies[point(row).b], &ImpactBody::change);
    }

    double solve_normal(ImpactRow& row) {
        const double old = row.normal_impulse;
        row.normal_impulse = std::max(old - row.normal_mass * speed(row, row.normal), 0.0);
        const double change = row.normal_impulse - old;
        push(row, row.normal, change);
        point(row).normal_impulse += change;
        return row.normal_mass > 0.0 ? std::abs(change) / row.normal_mass : 0.0;
    }

    // Coulomb friction against the impulse together with the bounce that follows.
    double solve_tangent(ImpactRow& row) {
        if (point(row).friction == 0.0 || row.tangent_mass == 0.0) return 0.0;
        const double bound = point(row).friction * (1.0 + row.restitution) * row.normal_impulse;
        const double slip = speed(row, row.tangent) + point(row).tangent_speed;
        const double old = row.tangent_impulse;
        row.tangent_impulse = std::clamp(old - row.tangent_mass * slip, -bound, bound);
        const double change = row.tangent_impulse - old;
        push(row, row.tangent, change);
        point(row).tangent_impulse += change;
        return std::abs(change) / row.tangent_mass;
    }

    // Applies e times the impulses of the round, or the largest part of that which leaves no more than `energy`.
    void bounce(double energy) {
        const double before = kinetic_energy(group_);
        push_bounces(1.0);
        const double part = affordable_part(before, kinetic_energy(group_), energy);
        push_bounces(part - 1.0);
        for (const ImpactRow& row : group_.rows) {
            point(row).normal_impulse += part * row.restitution * row.normal_impulse;
            point(row).bounce_count += row.restitution > 0.0;
        }
    }

    void push_bounces(double part) {
        if (part == 0.0) return;
        for (const ImpactRow& row : group_.rows)
            if (row.restitution > 0.0) push(row, row.normal, part * row.restitution * row.normal_impulse);
    }

    // The round left the points that pushed at rest along their normals. So the energy of a part t of the bounce is
    // before + t^2 (after - before).
    static double affordable_part(double before, double after, double energy) {
        if (!(after > energy * (1.0 + 1e-12))) return 1.0;
        return std::sqrt(std::clamp((energy - before) / (after - before), 0.0, 1.0));
    }

    // Keeps the points apart during the motion ahead, by the same sweeps and without friction.
    void hold() {
        group_.rows.clear();
        for (ImpactBody& body : group_.bodies) body.hold = {};
        for (std::size_t i = 0; i < group_.points.size(); ++i) group_.rows.push_back(make_row(group_, i));
        for (int i = 0; i < kMaxHoldSweeps; ++i) {
            double largest = 0.0;
            for (ImpactRow& row : group_.rows) largest = std::max(largest, hold(row));
            if (!(largest > kTolerance * fastest_)) break;
        }
    }

    double hold(ImpactRow& row) {
        ImpactBody &a = group_.bodies[point(row).a], &b = group_.bodies[point(row).b];
        const double old = row.normal_impulse;
        row.normal_impulse = std::max(old - row.normal_mass * speed_ahead(row.normal, a, b), 0.0);
        apply(row.normal, row.normal_impulse - old, a, b, &ImpactBody::hold);
        return row.normal_mass > 0.0 ? std::abs(row.normal_impulse - old) / row.normal_mass : 0.0;
    }

    ImpactGroup& group_;
    double fastest_ = 0.0;  // approach, m/s
    double tolerance_ = kInelasticTolerance;
    int work_ = 0;
};

}  // namespace

double approach_at_impact(const ImpactGroup& group, const ImpactPoint& point) {
    TUMBLE_CHECK(point.a < group.bodies.size());
    TUMBLE_CHECK(point.b < group.bodies.size());
    return speed_at_impact(normal_of(point), group.bodies[point.a], group.bodies[point.b]);
}

double approach_ahead(const ImpactGroup& group, const ImpactPoint& point) {
    return speed_ahead(normal_of(point), group.bodies[point.a], group.bodies[point.b]);
}

void solve_impacts(ImpactGroup& group) { ImpactRounds(group).run(); }

}  // namespace tumble
