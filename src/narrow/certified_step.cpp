#include "narrow/certified_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "narrow/support.hpp"

namespace tumble {

namespace {

// An upper bound on tan(x) for 0 <= x <= 1: (tan x - x) / x^3 grows with x, to tan 1 - 1 = 0.55741.
double tangent_above(double x) { return x * (1.0 + 0.5575 * x * x); }

double positive_part(double x) { return x > 0.0 ? x : 0.0; }

// Lower bound gap - closing x - curvature x^2 on the separation, or what one term of it contributes.
struct Bound {
    double closing;
    double curvature;

    friend Bound operator+(Bound a, Bound b) { return {a.closing + b.closing, a.curvature + b.curvature}; }
};

// The first positive root of gap = closing x + curvature x^2, in the form that does not cancel; at most the window.
double root_of(Bound bound, double gap, double window) {
    const double discriminant = bound.closing * bound.closing + 4.0 * bound.curvature * gap;
    if (bound.closing > 0.0 && discriminant >= 0.0)
        return std::min(2.0 * gap / (bound.closing + std::sqrt(discriminant)), window);
    if (bound.closing > 0.0 || bound.curvature <= 0.0) return window;
    return std::min((std::sqrt(discriminant) - bound.closing) / (2.0 * bound.curvature), window);
}

// That root without a square root, from its series in the curvature; it may fall short of it or beyond by the third order.
double root_to_second_order(Bound bound, double gap) {
    if (!(bound.closing > 0.0)) return std::numeric_limits<double>::infinity();
    const double inverse = 1.0 / bound.closing, root = gap * inverse;
    return root * (1.0 + positive_part(-bound.curvature * root * inverse));
}

// f cos y <= f + c y^2 and f sin y <= f y + c y^2 for 0 <= y <= angle <= 1, from the alternating Taylor series: the term
// of second order is kept as it is, the first one left out is bounded at the end.
double cosine_curvature(double f, double angle) {
    return f > 0.0 ? -0.5 * f * (1.0 - angle * angle * (1.0 / 12.0)) : -0.5 * f;
}
double sine_curvature(double f, double angle) { return f > 0.0 ? 0.0 : -f * angle * (1.0 / 6.0); }

// A body as its axis sees it: the height of its support vertex and its lever, the height gained per radian.
struct Mover {
    const Core& core;
    DVec2 center;
    DVec2 outwards;
    int at;
    double rate;  // relative to the axis
    double height;
    double lever;
};

Mover make_mover(const Core& core, DVec2 center, DVec2 outwards, int at, double rate) {
    const DVec2 vertex = core.point(at) - center;
    return {core, center, outwards, at, rate, dot(outwards, vertex), std::copysign(1.0, rate) * cross(vertex, outwards)};
}

// How fast a point of the side's height and of this lever rises: height cos y + lever sin y after a turn by y.
Bound bound_rise(const Mover& side, double lever, double window) {
    const double turn = std::abs(side.rate), angle = turn * window;
    return {turn * lever, turn * turn * (cosine_curvature(side.height, angle) + sine_curvature(lever, angle))};
}

// The lever of the point X of the window. The direction turns away from one neighbour of the vertex, so that the vertex
// stays the support if the other one is lower.
double lever_within(const Mover& side, double window) {
    if (side.rate == 0.0 || side.core.count == 1) return side.lever;
    const double back = tangent_above(std::abs(side.rate) * window);
    const DVec2 turned_back = side.outwards - std::copysign(back, side.rate) * perp(side.outwards);
    const int neighbour = side.rate > 0.0 ? side.core.previous(side.at) : side.core.next(side.at);
    if (dot(turned_back, side.core.edge(side.at, neighbour)) < 0.0) return side.lever;
    const double height = support(side.core, turned_back).height - dot(turned_back, side.center);
    return std::max(side.lever, (height - side.height) / back);
}

// How fast the centres approach along a normal that turns at `rate`: -(far + along x) cos y + (aside + across x) sin y
// after the fraction x and a turn by y.
Bound bound_approach(DVec2 separation, DVec2 velocity, DVec2 normal, double rate, double window) {
    const double along = dot(normal, velocity);
    if (rate == 0.0) return {-along, 0.0};
    const double turn = std::abs(rate), angle = turn * window;
    const double far = dot(normal, separation), aside = std::copysign(1.0, rate) * cross(separation, normal);
    const double across = std::copysign(1.0, rate) * cross(velocity, normal);
    const double mixed = across > 0.0 ? across : across * (1.0 - angle * angle * (1.0 / 6.0));
    const double curvature = turn * turn * (cosine_curvature(-far, angle) + sine_curvature(aside, angle) +
                                            0.5 * positive_part(along) * window);
    return {turn * aside - along, curvature + turn * mixed};
}

// The three terms of the bound, for windows to be chosen.
class AxisBound {
public:
    AxisBound(const Motion& motion, const MovingCores& cores, const SeparatingAxis& axis)
        : motion_(motion), cores_(cores), axis_(axis),
          a_(make_mover(cores.pair.a, cores.center_a, axis.normal, axis.support_a, motion.turn_a() - axis.rate)),
          b_(make_mover(cores.pair.b, cores.center_b, -axis.normal, axis.support_b, motion.turn_b() - axis.rate)) {}

    // Where nothing turns by more than a radian.
    double cut(double window) const {
        const double fastest = std::max({std::abs(a_.rate), std::abs(b_.rate), std::abs(axis_.rate)});
        return fastest * window > 1.0 ? 1.0 / fastest : window;
    }

    Bound of_support_vertices(double window) const { return bound(a_.lever, b_.lever, window); }
    Bound of_all(double window) const { return bound(lever_within(a_, window), lever_within(b_, window), window); }

private:
    Bound bound(double lever_a, double lever_b, double window) const {
        return bound_approach(cores_.separation, motion_.velocity(), axis_.normal, axis_.rate, window) +
               (bound_rise(a_, lever_a, window) + bound_rise(b_, lever_b, window));
    }

    const Motion& motion_;
    const MovingCores& cores_;
    const SeparatingAxis& axis_;
    Mover a_;
    Mover b_;
};

}  // namespace

double certified_step(const Motion& motion, const MovingCores& cores, const SeparatingAxis& axis, double gap, double left) {
    const AxisBound bound(motion, cores, axis);
    const double longest = bound.cut(left);
    const double window = std::min(longest, root_to_second_order(bound.of_support_vertices(0.0), gap));
    return root_of(bound.of_all(window), gap, window);
}

double closing_rate(const Motion& motion, const MovingCores& cores, const SeparatingAxis& axis) {
    return AxisBound(motion, cores, axis).of_support_vertices(0.0).closing;
}

bool closes(const Motion& motion, const MovingCores& cores, const SeparatingAxis& axis) {
    constexpr double kInstant = 0x1p-20;  // of a radian, or of the motion
    const AxisBound bound(motion, cores, axis);
    if (bound.of_support_vertices(0.0).closing > motion.error()) return true;
    return bound.of_all(kInstant * bound.cut(1.0)).closing > motion.error();
}

}  // namespace tumble
