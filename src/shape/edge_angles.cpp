#include "shape/edge_angles.hpp"

#include <algorithm>
#include <numeric>

#include "shape/orientation.hpp"

namespace tumble {

void sort_edges(LargePolygon& polygon) {
    const std::size_t count = polygon.x.size();
    const auto vertex = [&](std::size_t i) { return Vec2{polygon.x[i % count], polygon.y[i % count]}; };
    std::vector<double> angles;
    for (std::size_t i = 0; i < count; ++i) {
        if (orientation(vertex(i), vertex(i + 1), vertex(i + 2)) <= 0) return;
        angles.push_back(square_angle(DVec2(vertex(i + 1)) - DVec2(vertex(i))));
    }
    const auto first = std::min_element(angles.begin(), angles.end());
    polygon.first_edge = static_cast<std::int32_t>(first - angles.begin());
    std::rotate(angles.begin(), first, angles.end());
    // Left turns only, and no angle but at the first edge falls by more than rounding: once round.
    constexpr double kRounding = 0x1p-48;
    for (std::size_t i = 1; i < count; ++i) {
        if (angles[i] < angles[i - 1] - kRounding) return;
        angles[i] = std::max(angles[i], angles[i - 1]);
    }
    const std::size_t sectors = 2 * count;  // one an edge is 6 % slower, four are as fast
    polygon.edges_before.assign(sectors + 1, 0);
    for (const double angle : angles) ++polygon.edges_before[sector_of(angle, sectors) + 1];
    std::partial_sum(polygon.edges_before.begin(), polygon.edges_before.end(), polygon.edges_before.begin());
    polygon.edge_angles = std::move(angles);
}

}  // namespace tumble
