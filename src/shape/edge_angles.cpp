#include "shape/edge_angles.hpp"

#include <algorithm>
#include <numeric>

#include "debug/check.hpp"
#include "shape/orientation.hpp"

namespace tumble {

namespace {

// True for angles from 0 to below half a turn. The signs are exact; the square angle of an edge that is almost parallel
// to the x axis is not.
bool points_upwards(DVec2 edge) { return edge.y > 0.0 || (edge.y == 0.0 && edge.x > 0.0); }

}  // namespace

void sort_edges(LargePolygon& polygon) {
    const std::size_t count = polygon.x.size();
    const auto vertex = [&](std::size_t i) { return Vec2{polygon.x[i % count], polygon.y[i % count]}; };
    const auto edge = [&](std::size_t i) { return DVec2(vertex(i + 1)) - DVec2(vertex(i)); };
    std::vector<double> angles;
    std::size_t first = 0;
    for (std::size_t i = 0; i < count; ++i) {
        if (orientation(vertex(i), vertex(i + 1), vertex(i + 2)) <= 0) return;
        angles.push_back(square_angle(edge(i)));
        if (points_upwards(edge(i)) && !points_upwards(edge(i + count - 1))) first = i;
    }
    polygon.first_edge = static_cast<std::int32_t>(first);
    std::rotate(angles.begin(), angles.begin() + polygon.first_edge, angles.end());
    // All turns are to the left. If no angle after the first falls by more than rounding, the outline winds once.
    constexpr double kRounding = 0x1p-48;
    for (std::size_t i = 1; i < count; ++i) {
        if (angles[i] < angles[i - 1] - kRounding) return;
        angles[i] = std::max(angles[i], angles[i - 1]);
    }
    TUMBLE_CHECK(std::is_sorted(angles.begin(), angles.end()));
    TUMBLE_CHECK(!(angles.front() < 0.0));  // NaN for vertices that are not finite
    TUMBLE_CHECK(!(angles.back() > 4.0));
    const std::size_t sectors = 2 * count;  // one sector for each edge is 6 % slower, four are as fast as two
    polygon.edges_before.assign(sectors + 1, 0);
    for (const double angle : angles) ++polygon.edges_before[sector_of(angle, sectors) + 1];
    std::partial_sum(polygon.edges_before.begin(), polygon.edges_before.end(), polygon.edges_before.begin());
    TUMBLE_CHECK(polygon.edges_before.back() == count);
    polygon.edge_angles = std::move(angles);
}

}  // namespace tumble
