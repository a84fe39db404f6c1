#include "dynamics/impacts/impact_group.hpp"

#include <algorithm>
#include <cmath>

#include "debug/check.hpp"

namespace tumble {

namespace {

// Relative to the fastest approach: below it a contact counts as not approached.
constexpr double kTolerance = 1e-6;

// A round ends when no pass changes a speed by more than this part of the fastest approach. What inelastic impacts
// leave, the contact solver of the next step stops: with a restitution of 0.5 a tolerance of 6e-4 will do.
constexpr double kElasticTolerance = 1e-7, kInelasticTolerance = 1e-2;

double tolerance(double restitution) {
    const double rest = 1.0 - std::min(restitution, 1.0), square = rest * rest;
    return kElasticTolerance + (kInelasticTolerance - kElasticTolerance) * square * square;
}

// A hold that is not complete leaves an overlap to the next step.
constexpr int kMaxHoldPasses = 50;

// The factor of successive over-relaxation for a row of n contacts on the ground, slightly too large on purpose
// (IMPACTS.md, step 8). Without it a pile of n layers needs about n times as many passes.
double best_relaxation(int contacts) {
    return contacts > 1 ? 2.0 / (1.0 + sin_cos(kPi / (2.0 * contacts + 1.0)).sin) : 1.0;
}

double speed_along(DVec2 axis, double across_a, double across_b, const Twist& a, const Twist& b) {
    return dot(b.linear - a.linear, axis) + b.angular * across_b - a.angular * across_a;
}
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

double speed_along(const ImpactDirection& d, const Twist& a, const Twist& b) {
    return speed_along(d.axis, d.across_a, d.across_b, a, b);
}

bool can_bounce(const ImpactPoint& point) { return point.restitution > 0.0 && point.bounce_count < kMaxBounces; }

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

ImpactRow make_row(const ImpactGroup& group, std::size_t index) {
    const ImpactPoint& point = group.points[index];
    const ImpactBody &a = group.bodies[point.a], &b = group.bodies[point.b];
    ImpactRow row;
    row.point = index;
    row.normal = make_direction(point, point.normal, a, b);
    row.normal.speed = speed_along(row.normal, a.velocity, b.velocity);
    row.tangent = make_direction(point, -perp(point.normal), a, b);
    row.tangent.speed = speed_along(row.tangent, a.velocity, b.velocity) + point.tangent_speed;
    row.friction = point.friction;
    row.restitution = bounces(group, point) ? effective_restitution(group, point) : 0.0;
    return row;
}

// Of the motion ahead, after the impacts.
ImpactRow make_hold_row(const ImpactGroup& group, std::size_t index) {
    const ImpactPoint& point = group.points[index];
    const ImpactBody &a = group.bodies[point.a], &b = group.bodies[point.b];
    ImpactRow row;
    row.point = index;
    row.normal = make_direction(point, point.normal, a, b);
    row.normal.speed = speed_along(row.normal, a.mean_velocity + a.change, b.mean_velocity + b.change);
    return row;
}

// Two rows whose normals hardly differ in effect are solved one after the other.
constexpr double kLeastDeterminant = 1e-9;

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

class ImpactRounds {
public:
    explicit ImpactRounds(ImpactGroup& group) : group_(group), relaxation_(best_relaxation(group.depth)) {
        for (const ImpactPoint& point : group.points) {
            fastest_ = std::max({fastest_, -approach_at_impact(group, point), -approach_ahead(group, point)});
            tolerance_ = std::min(tolerance_, tolerance(point.restitution));
        }
    }

    void run() {
        do {
            begin_round();
            while (pass() > tolerance_ * fastest_ && group_.work < kMaxImpactWork) {
            }
            bounce();
        } while (group_.work < kMaxImpactWork && has_impact());
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
        pair_up(group_.rows, group_.points);
        for (ImpactRow& row : group_.rows)
            for (ImpactDirection* const d : {&row.normal, &row.tangent})
                d->speed_at_start = speed(row, *d, &ImpactBody::change);
    }

    bool has_impact() const {
        return std::any_of(group_.points.begin(), group_.points.end(),
                           [&](const ImpactPoint& point) { return is_approached(point, point.threshold); });
    }

    // One pass of projected Gauss-Seidel over the rows. Returns the largest change of a relative speed, m/s.
    double pass() {
        group_.work += static_cast<int>(group_.rows.size());
        if (group_.work > kMaxImpactWork / 2) relaxation_ = 1.0;
        double largest = 0.0;
        for (std::size_t i = 0; i < group_.rows.size(); ++i) {
            ImpactRow& row = group_.rows[i];
            largest = std::max(largest, solve_normals(i, &ImpactBody::change));
            largest = std::max(largest, solve_tangent(row));
            if (row.is_paired) largest = std::max(largest, solve_tangent(group_.rows[++i]));
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

    void push(const ImpactRow& row, const ImpactDirection& d, double impulse, Twist ImpactBody::*target) {
        Twist& a = group_.bodies[point(row).a].*target;
        Twist& b = group_.bodies[point(row).b].*target;
        a = a + impulse * d.push_a;
        b = b + impulse * d.push_b;
    }

    // Changes the impulse to one within the bounds after which the bodies do not move along the direction. Returns the
    // change of their relative speed, m/s.
    double solve(const ImpactRow& row, ImpactDirection& d, double lower, double upper, Twist ImpactBody::*target) {
        return change(row, d, std::clamp(d.impulse - d.mass * speed(row, d, target), lower, upper), target);
    }

    // An over-relaxed impulse along a normal.
    double relaxed(double old, double solved) const { return std::max(old + relaxation_ * (solved - old), 0.0); }

    double speed(const ImpactRow& row, const ImpactDirection& d, Twist ImpactBody::*target) {
        return d.speed + speed_along(d, group_.bodies[point(row).a].*target, group_.bodies[point(row).b].*target);
    }

    double change(const ImpactRow& row, ImpactDirection& d, double impulse, Twist ImpactBody::*target) {
        const double old = d.impulse;
        if (impulse == old) return 0.0;
        d.impulse = impulse;
        push(row, d, impulse - old, target);
        return std::abs(impulse - old) / d.mass;
    }

    // One row, or two paired ones.
    double solve_normals(std::size_t index, Twist ImpactBody::*target) {
        ImpactRow& first = group_.rows[index];
        if (!first.is_paired) return solve_normal(first, target);
        ImpactRow& second = group_.rows[index + 1];
        const PairImpulses impulses = find_normals(first, second, target);
        const double change_of_first =
            change(first, first.normal, relaxed(first.normal.impulse, impulses.first), target);
        return std::max(change_of_first,
                        change(second, second.normal, relaxed(second.normal.impulse, impulses.second), target));
    }

    struct PairImpulses {
        double first = 0.0, second = 0.0;  // N s
    };

    // The impulses x >= 0 of two paired rows after which no speed w is negative, and x w = 0: both push, or one, or
    // none.
    PairImpulses find_normals(const ImpactRow& first, const ImpactRow& second, Twist ImpactBody::*target) {
        const ImpactDirection &d1 = first.normal, &d2 = second.normal;
        const double m1 = d1.mass, m2 = d2.mass, k = first.coupling;
        const double w1 = speed(first, d1, target) - d1.impulse / m1 - k * d2.impulse;  // without the two impulses
        const double w2 = speed(second, d2, target) - d2.impulse / m2 - k * d1.impulse;
        const double scale = 1.0 / (1.0 - m1 * m2 * k * k);
        const double x1 = -scale * m1 * (w1 - m2 * k * w2), x2 = -scale * m2 * (w2 - m1 * k * w1);
        if (x1 >= 0.0 && x2 >= 0.0) return {x1, x2};
        const double alone1 = std::max(-m1 * w1, 0.0), alone2 = std::max(-m2 * w2, 0.0);
        if (w2 + k * alone1 >= 0.0) return {alone1, 0.0};
        return {0.0, alone2};
    }

    double solve_normal(ImpactRow& row, Twist ImpactBody::*target) {
        ImpactDirection& d = row.normal;
        return change(row, d, relaxed(d.impulse, d.impulse - d.mass * speed(row, d, target)), target);
    }

    // Coulomb friction against the impulse together with the bounce that follows.
    double solve_tangent(ImpactRow& row) {
        const double bound = row.friction * (1.0 + row.restitution) * row.normal.impulse;
        return solve(row, row.tangent, -bound, bound, &ImpactBody::change);
    }

    // Applies e times the impulses of the round, or the largest part of that which returns no more work than the
    // contacts have taken in the round.
    void bounce() {
        double taken = 0.0;
        for (const ImpactRow& row : group_.rows)
            for (const ImpactDirection* const d : {&row.normal, &row.tangent})
                taken += 0.5 * d->impulse * (d->speed_at_start + speed(row, *d, &ImpactBody::change));
        const double work_before = work_at_present_speeds();
        push_bounces(1.0);
        const double part = affordable_part(-taken, work_before, 0.5 * (work_at_present_speeds() - work_before));
        push_bounces(part - 1.0);
        for (const ImpactRow& row : group_.rows) {
            point(row).normal_impulse += (1.0 + part * row.restitution) * row.normal.impulse;
            point(row).tangent_impulse += row.tangent.impulse;
            point(row).bounce_count += row.restitution > 0.0;
        }
    }

    // Of the impulses of the bounce at the present speeds, J.
    double work_at_present_speeds() {
        double work = 0.0;
        for (const ImpactRow& row : group_.rows)
            work += row.restitution * row.normal.impulse * speed(row, row.normal, &ImpactBody::change);
        return work;
    }

    void push_bounces(double part) {
        if (part == 0.0) return;
        for (const ImpactRow& row : group_.rows)
            if (row.restitution > 0.0)
                push(row, row.normal, part * row.restitution * row.normal.impulse, &ImpactBody::change);
    }

    // The largest part t <= 1 of the bounce whose work, linear t + square t^2, is at most `taken`, J. `linear` is what
    // the passes have left: exactly solved, the points that push are at rest along their normals.
    static double affordable_part(double taken, double linear, double square) {
        if (!(linear + square - taken > 1e-12 * (square + taken))) return 1.0;
        const double discriminant = linear * linear + 4.0 * square * std::max(taken, 0.0);
        return std::clamp((std::sqrt(discriminant) - linear) / (2.0 * square), 0.0, 1.0);
    }

    // Keeps the points apart during the motion ahead, by the same passes and without friction.
    void hold() {
        group_.rows.clear();
        for (ImpactBody& body : group_.bodies) body.hold = {};
        for (std::size_t i = 0; i < group_.points.size(); ++i) group_.rows.push_back(make_hold_row(group_, i));
        pair_up(group_.rows, group_.points);
        for (int i = 0; i < kMaxHoldPasses && group_.hold_work < kMaxImpactWork; ++i) {
            group_.hold_work += static_cast<int>(group_.rows.size());
            double largest = 0.0;
            for (std::size_t row = 0; row < group_.rows.size(); row += group_.rows[row].is_paired ? 2 : 1)
                largest = std::max(largest, solve_normals(row, &ImpactBody::hold));
            if (!(largest > kTolerance * fastest_)) break;
        }
    }

    ImpactGroup& group_;
    double relaxation_;     // of normal impulses
    double fastest_ = 0.0;  // approach, m/s
    double tolerance_ = kInelasticTolerance;
};

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

void solve_impacts(ImpactGroup& group) { ImpactRounds(group).run(); }

}  // namespace tumble
