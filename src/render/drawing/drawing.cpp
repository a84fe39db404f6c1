// The methods of Drawing: each appends one element, or the several of a dashed line, an arrow or a polyline.
#include "tumble/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "debug/check.hpp"
namespace tumble {

void Drawing::line(DVec2 from, DVec2 to, double width_px, Color color) {
    elements.emplace_back(DrawnLine{from, to, width_px, color});
}

void Drawing::dashed_line(DVec2 from, DVec2 to, double width_px, Color color, double begun) {
    constexpr double kDash = 6.0, kPeriod = 10.0;  // px
    static_assert(kDash < kPeriod);
    const double total = length(to - from);
    for (double dash = -std::fmod(begun, kPeriod); dash < total; dash += kPeriod) {
        const double start = std::max(dash, 0.0), end = std::min(dash + kDash, total);
        if (start < end)
            line(from + (start / total) * (to - from), from + (end / total) * (to - from), width_px, color);
    }
}

void Drawing::arrow(DVec2 from, DVec2 to, double width_px, Color color) {
    const double total = length(to - from);
    if (total == 0.0) return;
    const double head = std::min(4.0 + 3.0 * width_px, total);
    TUMBLE_CHECK(head > 0.0);
    const DVec2 along = (1.0 / total) * (to - from);
    const DVec2 neck = to - head * along;
    const DVec2 side = (0.4 * head) * perp(along);
    line(from, neck, width_px, color);
    polygon({to, neck + side, neck - side}, color, 0.0, color);
}

void Drawing::polyline(const std::vector<DVec2>& points, double width_px, Color color) {
    for (std::size_t i = 1; i < points.size(); ++i) line(points[i - 1], points[i], width_px, color);
}

void Drawing::polygon(std::vector<DVec2> points, Color fill, double outline_width, Color outline) {
    elements.emplace_back(DrawnPolygon{std::move(points), fill, outline_width, outline});
}

void Drawing::disc(DVec2 center, double radius, Color fill, double outline_width, Color outline) {
    elements.emplace_back(DrawnDisc{center, radius, fill, outline_width, outline});
}

void Drawing::text(DVec2 at, std::string text, double size, Color color, TextAnchor anchor) {
    elements.emplace_back(DrawnText{at, std::move(text), size, color, anchor});
}

}  // namespace tumble
