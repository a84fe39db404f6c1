#include "dynamics/impacts/impact_group.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dynamics/impacts/impact_rows.hpp"
#include "dynamics/impacts/point_impulse.hpp"

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

// The changes must have halved after this many times n + 1 passes, for a group of depth n. The slowest rows of
// IMPACTS.md, step 8, need 0.25 n + 1 passes for that.
constexpr int kPassesPerLayer = 8;

// The passes diverge if one of them changes a speed by more than this multiple of the fastest approach.
constexpr double kRunawayChange = 1e9;

// Of the fastest approach: a contact that still has this part of it after the passes is jammed by friction.
constexpr double kJammedPart = 0.1;

// A hold that is not complete leaves an overlap to the next step.
constexpr int kMaxHoldPasses = 50;

// The factor of successive over-relaxation for a row of n contacts on the ground, slightly too large on purpose
// (IMPACTS.md, step 8). Without it a pile of n layers needs about n times as many passes.
double best_relaxation(int contacts) {
    return contacts > 1 ? 2.0 / (1.0 + sin_cos(kPi / (2.0 * contacts + 1.0)).sin) : 1.0;
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
        bool is_settled = true;
        do {
            begin_round();
            is_settled = settle();
            if (is_settled ? is_jammed() : work() > 0.0) {
                begin_again_without_friction();
                is_settled = settle() && !is_jammed();
            }
            bounce();
        } while (is_settled && group_.work < kMaxImpactWork && has_impact());
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
        for (ImpactBody& body : group_.bodies) body.earlier_change = body.change;
    }

    void begin_again_without_friction() {
        for (ImpactRow& row : group_.rows) {
            row.friction = 0.0;
            row.normal.impulse = row.tangent.impulse = 0.0;
        }
        for (ImpactBody& body : group_.bodies) body.change = body.earlier_change;
    }

    // Passes until they hardly change a speed. Returns false if the changes do not fade (IMPACTS.md, step 10).
    bool settle() {
        const int passes = kPassesPerLayer * (group_.depth + 1);
        for (double before = std::numeric_limits<double>::infinity();;) {
            double largest = 0.0;
            for (int i = 0; i < passes; ++i) {
                largest = pass();
                if (!(largest > tolerance_ * fastest_)) return true;
                if (group_.work >= kMaxImpactWork || !(largest < kRunawayChange * fastest_)) return false;
            }
            if (largest > 0.5 * before) return false;
            before = largest;
        }
    }

    // True if a contact that only keeps its bodies apart is approached although the passes have settled.
    bool is_jammed() {
        return std::ranges::any_of(group_.rows, [&](const ImpactRow& row) {
            const double least = std::max(kJammedPart * fastest_, point(row).threshold);
            return row.restitution == 0.0 && row.normal.mass > 0.0 &&
                   speed(row, row.normal, &ImpactBody::change) < -least;
        });
    }

    bool has_impact() const {
        return std::any_of(group_.points.begin(), group_.points.end(),
                           [&](const ImpactPoint& point) { return is_approached(point, point.threshold); });
    }

    // One pass of projected Gauss-Seidel over the rows. Returns the largest change of a relative speed, m/s.
    double pass() {
        group_.work += static_cast<int>(group_.rows.size());
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
        Twist& a = group_.bodies[row.a].*target;
        Twist& b = group_.bodies[row.b].*target;
        a = a + impulse * d.push_a;
        b = b + impulse * d.push_b;
    }

    // Changes the impulse to one within the bounds after which the bodies do not move along the direction. Returns the
    // change of their relative speed, m/s.
    double solve(const ImpactRow& row, ImpactDirection& d, double lower, double upper, Twist ImpactBody::*target) {
        return change(row, d, std::clamp(d.impulse - d.mass * speed(row, d, target), lower, upper), target);
    }

    // The over-relaxation under which an impulse along a normal does not pull.
    double feasible_relaxation(double old, double solved) const {
        return solved < old ? std::min(relaxation_, old / (old - solved)) : relaxation_;
    }

    static double relaxed(double old, double solved, double relaxation) {
        return std::max(old + relaxation * (solved - old), 0.0);
    }

    double speed(const ImpactRow& row, const ImpactDirection& d, Twist ImpactBody::*target) {
        return d.speed + speed_along(d, group_.bodies[row.a].*target, group_.bodies[row.b].*target);
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
        const double old1 = first.normal.impulse, old2 = second.normal.impulse;
        const double k =
            std::min(feasible_relaxation(old1, impulses.first), feasible_relaxation(old2, impulses.second));
        const double change1 = change(first, first.normal, relaxed(old1, impulses.first, k), target);
        const double change2 = change(second, second.normal, relaxed(old2, impulses.second, k), target);
        return std::max(change1, change2);
    }

    struct PairImpulses {
        double first = 0.0, second = 0.0;  // N s
    };

    // The impulses x >= 0 of two paired rows after which no speed w is negative, and x w = 0: both push, or one, or
    // none. For one alone its friction is taken into account.
    PairImpulses find_normals(const ImpactRow& first, const ImpactRow& second, Twist ImpactBody::*target) {
        const ImpactDirection &d1 = first.normal, &d2 = second.normal;
        const double m1 = d1.mass, m2 = d2.mass, k = first.coupling;
        const double w1 = speed(first, d1, target) - d1.impulse / m1 - k * d2.impulse;  // without the two impulses
        const double w2 = speed(second, d2, target) - d2.impulse / m2 - k * d1.impulse;
        const double scale = 1.0 / (1.0 - m1 * m2 * k * k);
        const double x1 = -scale * m1 * (w1 - m2 * k * w2), x2 = -scale * m2 * (w2 - m1 * k * w1);
        if (x1 >= 0.0 && x2 >= 0.0) return {x1, x2};
        const double alone1 = find_alone(first, second, target);
        if (w2 + k * alone1 >= 0.0) return {alone1, 0.0};
        return {0.0, find_alone(second, first, target)};
    }

    // The impulse of one of two paired rows if the other does not push.
    double find_alone(const ImpactRow& row, const ImpactRow& other, Twist ImpactBody::*target) {
        const auto by_other = [&](const ImpactDirection& d) {
            return speed_along(d, other.normal.push_a, other.normal.push_b) * other.normal.impulse;
        };
        return find_normal(row, speed(row, row.normal, target) - by_other(row.normal),
                           [&] { return speed(row, row.tangent, target) - by_other(row.tangent); });
    }

    // The impulse x >= 0 of a row at the present speeds, which contain its present impulses.
    template <class TangentSpeed>
    static double find_normal(const ImpactRow& row, double normal_speed, TangentSpeed&& tangent_speed) {
        const ImpactDirection &normal = row.normal, &tangent = row.tangent;
        const double c = row.tangent_coupling;
        if (c == 0.0 || row.friction == 0.0) return std::max(normal.impulse - normal.mass * normal_speed, 0.0);
        const PointResponse response{1.0 / normal.mass, 1.0 / tangent.mass, c};
        return find_point_impulse(response, normal_speed - response.normal * normal.impulse - c * tangent.impulse,
                                  tangent_speed() - c * normal.impulse - response.tangent * tangent.impulse,
                                  friction_with_bounce(row));
    }

    double solve_normal(ImpactRow& row, Twist ImpactBody::*target) {
        ImpactDirection& d = row.normal;
        const double solved = find_normal(row, speed(row, d, target), [&] { return speed(row, row.tangent, target); });
        return change(row, d, relaxed(d.impulse, solved, relaxation_), target);
    }

    // Coulomb friction against the impulse together with the bounce that follows.
    static double friction_with_bounce(const ImpactRow& row) { return row.friction * (1.0 + row.restitution); }

    double solve_tangent(ImpactRow& row) {
        const double bound = friction_with_bounce(row) * row.normal.impulse;
        if (bound == 0.0 && row.tangent.impulse == 0.0) return 0.0;
        return solve(row, row.tangent, -bound, bound, &ImpactBody::change);
    }

    // Of the impulses of the round so far, J.
    double work() {
        double result = 0.0;
        for (const ImpactRow& row : group_.rows)
            for (const ImpactDirection* const d : {&row.normal, &row.tangent})
                result += 0.5 * d->impulse * (d->speed_at_start + speed(row, *d, &ImpactBody::change));
        return result;
    }

    // Applies e times the impulses of the round, or the largest part of that which returns no more work than the
    // contacts have taken in the round.
    void bounce() {
        const double taken = -work();
        const double work_before = work_at_present_speeds();
        push_bounces(1.0);
        const double part = affordable_part(taken, work_before, 0.5 * (work_at_present_speeds() - work_before));
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
        const double root = std::sqrt(linear * linear + 4.0 * square * std::max(taken, 0.0));
        if (!(root > 0.0)) return 0.0;
        const double part =
            linear > 0.0 ? 2.0 * std::max(taken, 0.0) / (linear + root) : (root - linear) / (2.0 * square);
        return std::clamp(part, 0.0, 1.0);
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

void solve_impacts(ImpactGroup& group) { ImpactRounds(group).run(); }

}  // namespace tumble
