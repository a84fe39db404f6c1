#include "render/shapes/mitre.hpp"

#include <algorithm>

#include "debug/check.hpp"
namespace tumble::render {

DVec2 right_normal(DVec2 a, DVec2 b) {
    const DVec2 edge = b - a;
    const double size = length(edge);
    return size > 0.0 ? (-1.0 / size) * perp(edge) : DVec2{};
}

std::vector<DVec2> mitres(std::span<const DVec2> points, bool is_closed) {
    constexpr double kLongest = 4.0;
    const std::size_t count = points.size();
    TUMBLE_CHECK(count >= 1);
    std::vector<DVec2> result(count);
    for (std::size_t i = 0; i < count; ++i) {
        DVec2 before = right_normal(points[(i + count - 1) % count], points[i]);
        DVec2 after = right_normal(points[i], points[(i + 1) % count]);
        if (!is_closed && i == 0) before = after;
        if (!is_closed && i + 1 == count) after = before;
        const DVec2 sum = before + after;  // its length is 2 cos(half the turn), the mitre's 1 / cos(half the turn)
        result[i] = (2.0 / std::max(length_sq(sum), 4.0 / (kLongest * kLongest))) * sum;
    }
    return result;
}

}  // namespace tumble::render
