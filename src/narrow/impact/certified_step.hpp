// How far two moving cores can move while the separation along a direction is proved to stay above a floor.
//
// The direction n turns at a rate W: that of the face that it is normal to, or 0. Within a window in which nothing
// turns by more than a radian, the Taylor series of sine and cosine bound the approach of the centres, and each core's
// height along n is bounded by the point where its support lines at both ends of the window intersect. Repeated steps
// converge cubically, where conservative advancement by the largest speed [Mirtich 1996] converges linearly.
// CERTIFIED_STEP.md has the proof.
#pragma once

#include "narrow/impact/moving_cores.hpp"

namespace tumble {

// A direction that separates the cores, from A to B.
struct SeparatingAxis {
    DVec2 normal;     // unit
    double rate;      // W, radians a whole motion
    int supports[2];  // the vertices that support A in n and B in -n
    int owner;        // 0 or 1: the core that the normal turns with, whose height along it stays as it is; -1: none
};

// An x <= `left` up to which the separation along the axis is proved to stay above the floor; `gap` is the separation
// less the floor at the start, not negative.
double certified_step(const Motion& motion, const MovingCores& cores, const SeparatingAxis& axis, double gap,
                      double left);

struct Closing {
    double rate;     // at which the two support vertices approach along the axis
    bool is_proved;  // the separation begins to shrink, by any vertex, at a rate that takes it beyond rounding
};

Closing closing_along(const Motion& motion, const MovingCores& cores, const SeparatingAxis& axis);

}  // namespace tumble
