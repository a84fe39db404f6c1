#include "narrow/large_support.hpp"

#include "shape/edge_angles.hpp"

namespace tumble {

namespace {

// The first edge, counted from `first_edge`, that is not before the angle; their number if all are. Without a branch that
// could be mispredicted.
std::size_t first_not_before(const std::vector<double>& angles, double angle) {
    const double* first = angles.data();
    for (std::size_t left = angles.size(); left > 1;) {
        const std::size_t half = left / 2;
        first += first[half - 1] < angle ? half : 0;
        left -= half;
    }
    return static_cast<std::size_t>(first - angles.data()) + (*first < angle);
}

}  // namespace

int large_support(const LargePolygon& polygon, DVec2 direction) {
    const int count = static_cast<int>(polygon.x.size());
    const auto next = [count](int i) { return i + 1 < count ? i + 1 : 0; };
    const auto previous = [count](int i) { return i > 0 ? i - 1 : count - 1; };
    const auto rise = [&](int from, int to) {  // along the edge; its coordinates are exact or round once
        const auto i = static_cast<std::size_t>(from), j = static_cast<std::size_t>(to);
        return direction.x * (static_cast<double>(polygon.x[j]) - polygon.x[i]) +
               direction.y * (static_cast<double>(polygon.y[j]) - polygon.y[i]);
    };
    // Edges rise until they point a quarter turn to the left of the direction.
    const auto falling = static_cast<int>(first_not_before(polygon.edge_angles, square_angle(perp(direction))));
    int at = (polygon.first_edge + falling) % count;
    int steps = count;  // for a direction of zero or infinity
    while (steps-- > 0 && rise(at, next(at)) > 0.0) at = next(at);
    while (steps-- > 0 && rise(at, previous(at)) > 0.0) at = previous(at);
    return at;
}

}  // namespace tumble
