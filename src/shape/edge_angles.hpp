// The directions of a large polygon's edges in angular order: a support vertex is found in them by bisection.
#pragma once

#include <cmath>

#include "tumble/math.hpp"
#include "tumble/shape.hpp"

namespace tumble {

// The point at which the ray in a direction leaves the square |x| + |y| = 1, measured along the square from the x axis,
// 0 to 4. It grows with the angle and needs no trigonometry. Within 2^-50 of the exact value; NaN for the direction 0.
inline double square_angle(DVec2 direction) {
    const double share = direction.x / (std::abs(direction.x) + std::abs(direction.y));
    return direction.y >= 0.0 ? 1.0 - share : 3.0 + share;
}

// The index of the sector, of equally large ones, that contains a square angle; the last one for NaN. Monotone in the
// angle.
inline std::size_t sector_of(double angle, std::size_t sectors) {
    const double at = angle * (0.25 * static_cast<double>(sectors));
    return at < static_cast<double>(sectors) ? static_cast<std::size_t>(at) : sectors - 1;
}

// Fills in `edge_angles`, `edges_before` and `first_edge` if the outline is strictly convex, counter-clockwise and
// winds once. Otherwise `edge_angles` stays empty.
void sort_edges(LargePolygon& polygon);

}  // namespace tumble
