#include "render/shapes/hatching.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "render/shapes/outline_mesh.hpp"
#include "render/shapes/shape_primitives.hpp"
#include "render/style/style.hpp"

namespace tumble::render {
namespace {

constexpr DVec2 kAlong{1.0, 1.0};

// The part of the line from + t kAlong in a convex polygon, counter-clockwise: the least and the largest t.
std::optional<std::pair<double, double>> part_inside(const std::vector<DVec2>& polygon, DVec2 from) {
    double first = -1e9, last = 1e9;  // pixels: farther than any frame
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const DVec2 edge = polygon[(i + 1) % polygon.size()] - polygon[i];
        const double rise = cross(edge, kAlong), start = cross(edge, from - polygon[i]);  // inside: start + t rise >= 0
        if (rise > 0.0) first = std::max(first, -start / rise);
        if (rise < 0.0) last = std::min(last, -start / rise);
        if (rise == 0.0 && start < 0.0) return std::nullopt;
    }
    if (first >= last) return std::nullopt;
    return std::pair(first, last);
}

}  // namespace

void add_hatching(Layer& layer, const View& view, const Shape& shape, const Pose& pose, Color color) {
    const std::vector<DVec2> outline = pixel_outline(view, shape, pose);
    if (outline.size() < 3) return;
    // The line number k has x - y = k step - origin, in pixels.
    const double step = style::kHatchSpacing * std::numbers::sqrt2 * view.detail();
    const double origin = view.scale * (view.center.x - view.center.y);
    double least = 0.5 * (view.width + view.height), most = -least;
    for (const DVec2 corner : outline) {
        least = std::min(least, corner.x - corner.y);
        most = std::max(most, corner.x - corner.y);
    }
    const double edge = 0.5 * (view.width + view.height);  // of the frame, in x - y
    least = std::max(least, -edge);
    most = std::min(most, edge);
    // Counted from the frame's middle: far from the origin of the world, k + 1 could be k.
    const double phase = std::fmod(origin, step);
    for (double k = std::ceil((least + phase) / step); k * step - phase <= most; k += 1.0) {
        const double offset = k * step - phase;
        const DVec2 from{0.5 * offset, -0.5 * offset};
        if (const auto part = part_inside(outline, from))
            add_line(layer, view, from + part->first * kAlong, from + part->second * kAlong,
                     style::kHatchWidth * view.detail(), color);
    }
}

}  // namespace tumble::render
