#include "render/frame/marks.hpp"

#include <algorithm>

#include "render/shapes/shape_primitives.hpp"

namespace tumble::render {
namespace {

// Lengths in pixels at 720 rows.
constexpr double kDot = 3.2;
constexpr double kHead = 6.0;

}  // namespace

void Marks::dot(DVec2 at, Color color) {
    const double radius = pixels(kDot);
    if (!view_.is_in_view(at, radius)) return;
    layer_.circles.push_back(
        {static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(radius), {color, background_}});
}

void Marks::line(DVec2 from, DVec2 to, double width, Color color) {
    add_line(layer_, view_, from, to, pixels(width), color);
}

void Marks::arrow(DVec2 from, DVec2 to, Color color) {
    const DVec2 along = to - from;
    const double size = length(along);
    if (size < pixels(kMarkWidth)) return;
    line(from, to, kMarkWidth, color);
    const DVec2 back = (std::min(pixels(kHead), 0.5 * size) / size) * along;
    for (const double side : {-0.6, 0.6}) line(to, to - back + side * perp(back), kMarkWidth, color);
}

}  // namespace tumble::render
