// The numbers in brackets are those of the steps and inequalities in CERTIFIED_STEP.md.
#include "narrow/impact/certified_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "debug/check.hpp"
#include "narrow/cores/support.hpp"

namespace tumble {

namespace {

// Lower bound gap - closing x - curvature x^2 on the separation, or what one term of it contributes.
struct Bound {
    double closing;
    double curvature;

    friend Bound operator+(Bound a, Bound b) { return {a.closing + b.closing, a.curvature + b.curvature}; }
};

// An upper bound on tan(x) for 0 <= x <= 1 [step 4].
double tangent_above(double x) {
    TUMBLE_CHECK(x >= 0.0);
    TUMBLE_CHECK(x <= 1.0 + 0x1p-40);
    return x * (1.0 + 0.5575 * x * x);
}

double positive_part(double x) { return x > 0.0 ? x : 0.0; }

// At most the first positive root of gap = closing x + curvature x^2, and at most the window [step 5]. Takes a square
// root only if the bound does not close at first.
double root_of(Bound bound, double gap, double window) {
    const double closing = bound.closing, curvature = bound.curvature;
    if (closing > 0.0) {
        const double near = curvature < 0.0 ? gap / closing : window;
        return closing * closing + 4.0 * curvature * gap < 0.0 ? window
                                                               : std::min(gap / (closing + curvature * near), window);
    }
    if (curvature <= 0.0) return window;
    return std::min((std::sqrt(closing * closing + 4.0 * curvature * gap) - closing) / (2.0 * curvature), window);
}

// About that root, for the choice of the window [step 6]: gap / closing, and for a negative curvature the next term of
// the root's series in the curvature.
double root_to_second_order(Bound bound, double gap) {
    if (!(bound.closing > 0.0)) return std::numeric_limits<double>::infinity();
    const double inverse = 1.0 / bound.closing, root = gap * inverse;
    return root * (1.0 + positive_part(-bound.curvature * root * inverse));
}

// The constants c of f cos y <= f + c y^2 and f sin y <= f y + c y^2 for 0 <= y <= angle <= 1 [step 1]. Without
// branches on signs, which a processor cannot predict.
double cosine_curvature(double f, double angle) { return -0.5 * f + positive_part(f) * (angle * angle * (1.0 / 24.0)); }
double sine_curvature(double f, double angle) { return positive_part(-f) * (angle * (1.0 / 6.0)); }

// A body relative to the axis: the height of its support vertex and its lever, the height gained per radian.
struct Mover {
    const Core& core;
    DVec2 center;
    DVec2 outwards;
    int at;
    double rate;  // relative to the axis
    double height;
    double lever;
};

[[gnu::always_inline]] inline Mover make_mover(const Core& core, DVec2 center, DVec2 outwards, int at, double rate) {
    const DVec2 vertex = core.point(at) - center;
    return {
        core, center, outwards, at, rate, dot(outwards, vertex), std::copysign(1.0, rate) * cross(vertex, outwards)};
}

// How fast a point of the side's height and of this lever rises: height cos y + lever sin y after a turn by y [step 3].
[[gnu::always_inline]] inline Bound bound_rise(const Mover& side, double lever, double window) {
    TUMBLE_CHECK(window >= 0.0);
    const double turn = std::abs(side.rate), angle = turn * window;
    TUMBLE_CHECK(angle <= 1.0 + 0x1p-40);
    return {turn * lever, turn * turn * (cosine_curvature(side.height, angle) + sine_curvature(lever, angle))};
}

// The height that a core has in the direction turned back by an angle of this tangent, as a lever.
[[gnu::noinline]] double lever_of_support(const Core& core, DVec2 center, double height, DVec2 turned_back, double back,
                                          int near) {
    return ((support(core, turned_back, near).height - dot(turned_back, center)) - height) / back;
}

// The lever of the point X of the window [step 4]. The direction turns away from one neighbour of the vertex, so the
// vertex stays the support if the other neighbour is lower.
[[gnu::always_inline]] inline double lever_within(const Mover& side, double window) {
    const Core& core = side.core;
    if (side.rate == 0.0 || core.count == 1) return side.lever;
    const double back = tangent_above(std::abs(side.rate) * window);
    const DVec2 turned_back = side.outwards - std::copysign(back, side.rate) * perp(side.outwards);
    const int next = core.next(side.at), previous = core.previous(side.at);
    if (dot(turned_back, core.edge(side.at, side.rate > 0.0 ? previous : next)) < 0.0) return side.lever;
    return std::max(side.lever, lever_of_support(core, side.center, side.height, turned_back, back, side.at));
}

// How the centres approach along a normal that turns: by -(far + along x) cos y + (aside + across x) sin y after the
// fraction x and a turn by y [step 2].
struct Approach {
    double turn;
    double far;
    double aside;
    double along;
    double across;

    [[gnu::always_inline]] Bound bound(double window) const {
        const double angle = turn * window, mixed = across + positive_part(-across) * (angle * angle * (1.0 / 6.0));
        const double curvature =
            turn * turn *
            (cosine_curvature(-far, angle) + sine_curvature(aside, angle) + 0.5 * positive_part(along) * window);
        return {turn * aside - along, curvature + turn * mixed};
    }
};

[[gnu::always_inline]] inline Approach make_approach(DVec2 separation, DVec2 velocity, DVec2 normal, double rate) {
    const double sign = std::copysign(1.0, rate);
    return {std::abs(rate), dot(normal, separation), sign * cross(separation, normal), dot(normal, velocity),
            sign * cross(velocity, normal)};
}

// The part of the window in which nothing turns by more than a radian.
double cut(double window, double fastest) { return fastest * window > 1.0 ? 1.0 / fastest : window; }

// The terms of the bound along an axis that turns with one core; the other core moves relative to it.
struct FaceView {
    Approach approach;
    Mover mover;

    double fastest() const { return std::max(approach.turn, std::abs(mover.rate)); }
    [[gnu::always_inline]] Bound of_support_vertices(double window) const {
        return approach.bound(window) + bound_rise(mover, mover.lever, window);
    }
    [[gnu::always_inline]] Bound of_all(double window) const {
        return approach.bound(window) + bound_rise(mover, lever_within(mover, window), window);
    }
};

// The terms along an axis that does not turn.
struct FixedView {
    Approach approach;
    Mover a;
    Mover b;

    double fastest() const { return std::max(std::abs(a.rate), std::abs(b.rate)); }
    [[gnu::always_inline]] Bound of_support_vertices(double window) const {
        return approach.bound(window) + (bound_rise(a, a.lever, window) + bound_rise(b, b.lever, window));
    }
    [[gnu::always_inline]] Bound of_all(double window) const {
        return approach.bound(window) +
               (bound_rise(a, lever_within(a, window), window) + bound_rise(b, lever_within(b, window), window));
    }
};

// Calls use(view) with the view of the axis's kind.
template <typename Use>
[[gnu::always_inline]] inline auto with_view(const Motion& motion, const MovingCores& cores, const SeparatingAxis& axis,
                                             Use use) {
    const Approach approach = make_approach(cores.separation, motion.velocity(), axis.normal, axis.rate);
    const Core* const both[2] = {&cores.pair.a, &cores.pair.b};
    const DVec2* const centers[2] = {&cores.center_a, &cores.center_b};
    const double turns[2] = {motion.turn_a(), motion.turn_b()};
    constexpr double kOutwards[2] = {1.0, -1.0};
    const auto mover = [&](int side) __attribute__((always_inline)) {
        // clang-tidy 14 takes the arrays for uninitialized. NOLINTNEXTLINE(clang-analyzer-core.CallAndMessage)
        return make_mover(*both[side], *centers[side], kOutwards[side] * axis.normal, axis.supports[side],
                          turns[side] - axis.rate);
    };
    if (axis.owner >= 0) return use(FaceView{approach, mover(1 - axis.owner)});
    return use(FixedView{approach, mover(0), mover(1)});
}

}  // namespace

double certified_step(const Motion& motion, const MovingCores& cores, const SeparatingAxis& axis, double gap,
                      double left) {
    constexpr int kRetries = 4;
    return with_view(
        motion, cores, axis, [ gap, left ](const auto& view) __attribute__((always_inline)) {
            TUMBLE_CHECK(left >= 0.0);
            TUMBLE_CHECK(left <= 1.0);
            TUMBLE_CHECK(gap >= 0.0);
            const double longest = cut(left, view.fastest());
            double window = std::min(longest, root_to_second_order(view.of_support_vertices(0.0), gap));
            double step = root_of(view.of_all(window), gap, window);
            // A window in which the support changes may allow much less than one in which it does not.
            for (int retry = 0; retry < kRetries && 0.0 < step && step < 0.25 * window; ++retry) {
                window = std::sqrt(step * window);
                step = std::max(step, root_of(view.of_all(window), gap, window));
            }
            return step;
        });
}

Closing closing_along(const Motion& motion, const MovingCores& cores, const SeparatingAxis& axis) {
    constexpr double kInstant = 0x1p-20;  // as a part of a radian, or of the motion
    return with_view(motion, cores, axis, [&motion](const auto& view) {
        const double rate = view.of_support_vertices(0.0).closing;
        const bool is_proved =
            rate > motion.error() || view.of_all(kInstant * cut(1.0, view.fastest())).closing > motion.error();
        return Closing{rate, is_proved};
    });
}

}  // namespace tumble
