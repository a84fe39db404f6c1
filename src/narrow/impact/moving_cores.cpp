#include "narrow/impact/moving_cores.hpp"

#include <algorithm>

#include "debug/check.hpp"
#include "math/turned.hpp"
#include "narrow/cores/error_bound.hpp"

namespace tumble {

namespace {

constexpr double kLargestSweepAngle = 1e6;

double largest_angle(const Sweep& sweep) { return std::abs(sweep.start_angle) + std::abs(sweep.turn); }

}  // namespace

Motion::Body Motion::make_body(const Shape& shape, const Sweep& sweep) {
    const DVec2 local_center(sweep.local_center);
    const double extent = shape.core_radius() + length(local_center);
    return {make_core(shape, {}), local_center, extent, sweep.turn, sin_cos(sweep.start_angle)};
}

// At given poses a core distance is within 9.5 u of the scale for separated cores, 13.4 u for overlapping ones and
// 15.8 u by a face of small cores (cores/ERROR_BOUND.md, steps 3, 5 and 7). Here the rotations round too: sine and
// cosine of the start by 4e-16 = 3.6 u each, hence a vertex by 5.1 u; those of the turn by as much, and their product
// with the start by 2.1 u; the angles by u of their size twice; the centres by 2 u of the displacements. All worst
// cases at once: 23.8 u, 27.7 u and 30.1 u. The products of a vertex with a rotation in double are not exact: 1.4 u
// more, which stays below 32 u.
Motion::Motion(const Shape& a, const Sweep& sweep_a, const Shape& b, const Sweep& sweep_b, double reach)
    : a_(make_body(a, sweep_a)),
      b_(make_body(b, sweep_b)),
      separation_(sweep_b.start - sweep_a.start),
      velocity_((sweep_b.end - sweep_b.start) - (sweep_a.end - sweep_a.start)) {
    const double displacements = length(sweep_a.end - sweep_a.start) + length(sweep_b.end - sweep_b.start);
    scale_ = a_.extent + b_.extent + length(separation_) + displacements;
    const double angles = largest_angle(sweep_a) * a_.extent + largest_angle(sweep_b) * b_.extent;
    error_ = kUnitRoundoff * (32.0 * scale_ + 4.0 * angles + 16.0 * reach);
    const CorePair pair{a_.core, b_.core, separation_, scale_};
    is_valid_ = tumble::is_valid(pair, a, b) && largest_angle(sweep_a) <= kLargestSweepAngle &&
                largest_angle(sweep_b) <= kLargestSweepAngle && reach >= 0.0 && reach <= kLargestScale;
}

[[gnu::always_inline]] inline void Motion::Body::turn(double fraction, Core& core_there, DVec2& center) const {
    TUMBLE_CHECK(fraction >= 0.0);
    TUMBLE_CHECK(fraction <= 1.0);
    const SinCos q = turned(start, fraction * turns);
    core_there.c = q.cos;
    core_there.s = q.sin;
    center.x = q.cos * local_center.x - q.sin * local_center.y;
    center.y = q.sin * local_center.x + q.cos * local_center.y;
}

void Motion::move(MovingCores& cores, double fraction) const {
    a_.turn(fraction, cores.pair.a, cores.center_a);
    b_.turn(fraction, cores.pair.b, cores.center_b);
    TUMBLE_CHECK(cores.pair.a.count == a_.core.count);
    TUMBLE_CHECK(cores.pair.b.count == b_.core.count);
    cores.separation.x = separation_.x + fraction * velocity_.x;
    cores.separation.y = separation_.y + fraction * velocity_.y;
    cores.pair.offset.x = cores.separation.x + (cores.center_a.x - cores.center_b.x);
    cores.pair.offset.y = cores.separation.y + (cores.center_a.y - cores.center_b.y);
}

MovingCores Motion::at(double fraction) const {
    MovingCores cores{{a_.core, b_.core, {}, scale_}, {}, {}, {}};
    move(cores, fraction);
    return cores;
}

}  // namespace tumble
