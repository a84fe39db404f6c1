#include "narrow/moving_cores.hpp"

#include <algorithm>

#include "narrow/error_bound.hpp"

namespace tumble {

namespace {

constexpr double kLargestAngle = 1e6;

double largest_angle(const Sweep& sweep) { return std::abs(sweep.start_angle) + std::abs(sweep.turn); }

}  // namespace

Motion::Body Motion::make_body(const Shape& shape, const Sweep& sweep) {
    const DVec2 local_center(sweep.local_center);
    const double extent = shape.core_radius() + length(local_center);
    return {make_core(shape, {}), local_center, extent, sweep.start_angle, sweep.turn, sin_cos(sweep.start_angle)};
}

// The core distance of poses that are given is within 16 u of the scale. Here the rotations are rounded too: the sine and
// cosine by 4e-16 = 3.6 u each, the angle by u of its size twice; the centres by 2 u of the ways.
Motion::Motion(const Shape& a, const Sweep& sweep_a, const Shape& b, const Sweep& sweep_b, double reach)
    : a_(make_body(a, sweep_a)), b_(make_body(b, sweep_b)), separation_(sweep_b.start - sweep_a.start),
      velocity_((sweep_b.end - sweep_b.start) - (sweep_a.end - sweep_a.start)) {
    const double ways = length(sweep_a.end - sweep_a.start) + length(sweep_b.end - sweep_b.start);
    scale_ = a_.extent + b_.extent + length(separation_) + ways;
    const double angles = largest_angle(sweep_a) * a_.extent + largest_angle(sweep_b) * b_.extent;
    error_ = kUnitRoundoff * (24.0 * scale_ + 4.0 * angles + 16.0 * reach);
    const CorePair pair{a_.core, b_.core, separation_, scale_};
    is_valid_ = tumble::is_valid(pair, a, b) && largest_angle(sweep_a) <= kLargestAngle &&
                largest_angle(sweep_b) <= kLargestAngle && reach >= 0.0 && reach <= kLargestScale;
}

void Motion::Body::turn_to(double fraction, Core& turned, DVec2& center) const {
    const SinCos q = turn == 0.0 || fraction == 0.0 ? start : sin_cos(start_angle + fraction * turn);
    turned = {core.x, core.y, core.count, q.cos, q.sin, core.large};
    center = {q.cos * local_center.x - q.sin * local_center.y, q.sin * local_center.x + q.cos * local_center.y};
}

MovingCores Motion::at(double fraction) const {
    MovingCores cores;
    a_.turn_to(fraction, cores.pair.a, cores.center_a);
    b_.turn_to(fraction, cores.pair.b, cores.center_b);
    cores.separation = separation_ + fraction * velocity_;
    cores.pair.offset = cores.separation + (cores.center_a - cores.center_b);
    cores.pair.scale = scale_;
    return cores;
}

}  // namespace tumble
