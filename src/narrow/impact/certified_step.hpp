// How far two moving cores can go before the separation along a direction may have fallen to a floor: a proof, not a
// guess.
//
// The direction n turns with a rate W of our choice (that of the face that it is normal to, or 0); seen from it each
// body turns at the rest of its own rate. Within a window [0, T] in which nothing turns by more than a radian,
//   - the separation of the centres along n is known up to the third order, by the Taylor series of sine and cosine;
//   - a body's height along n is at most that of the point X where its support lines in n and in n turned back through
//     the window intersect: every support line between them passes X or beneath it.
// The window is the step that the present support vertices alone would allow. If they support its end too, X is that
// vertex, the bound differs from the truth in the third order only, and repeated steps converge cubically, where
// conservative advancement by the largest speed [Mirtich 1996] converges linearly. Without turning a step is exact.
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

// The largest x <= `left` for which `gap`, the separation along the axis less the floor, is proved not to be used up.
double certified_step(const Motion& motion, const MovingCores& cores, const SeparatingAxis& axis, double gap,
                      double left);

struct Closing {
    double rate;     // at which the two support vertices approach along the axis
    bool is_proved;  // the separation begins to shrink, by any vertex, at a rate that takes it beyond rounding
};

Closing closing_along(const Motion& motion, const MovingCores& cores, const SeparatingAxis& axis);

}  // namespace tumble
