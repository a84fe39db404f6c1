#include "render/shapes/sensor_area.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "debug/check.hpp"
#include "render/shapes/outline_mesh.hpp"
#include "render/shapes/shape_primitives.hpp"
#include "render/style/style.hpp"
#include "render/view/clip.hpp"

namespace tumble::render {
namespace {

// Appends the dashes of one edge. `done` is the length of the outline before it, which gives the phase of the dashes.
// Only the part of the edge in view is divided.
void add_dashes(Layer& layer, const View& view, DVec2 from, DVec2 to, double done, Color color) {
    const double width = style::kSensorEdge * view.detail();
    const double dash = style::kDash * view.detail(), period = dash + style::kDashGap * view.detail();
    const DVec2 start = from;
    const double size = length(to - from);
    if (size == 0.0) return;
    const DVec2 along = (1.0 / size) * (to - from);
    if (!clip_segment(view, width, from, to)) return;
    const double first = length(from - start), last = length(to - start);
    TUMBLE_CHECK(period > dash);
    for (double at = std::floor((done + first) / period) * period - done; at < last; at += period) {
        const double begin = std::max(at, first), end = std::min(at + dash, last);
        if (begin < end) layer.boxes.push_back(make_line(start + begin * along, start + end * along, width, color));
    }
}

}  // namespace

void add_sensor_area(Layer& layer, const View& view, const Shape& shape, const Pose& pose, Paint paint) {
    const bool is_line = shape.vertex_count() == 2 && shape.radius() == 0.0f;
    if (!is_line) add_shape(layer, view, shape, pose, flat(faded(paint.fill, style::kSensorOpacity)), 0.0);
    const std::vector<DVec2> outline = pixel_outline(view, shape, pose);
    double done = 0.0;
    for (std::size_t i = 0; i + (is_line ? 1 : 0) < outline.size(); ++i) {
        const DVec2 from = outline[i], to = outline[(i + 1) % outline.size()];
        add_dashes(layer, view, from, to, done, paint.outline);
        done += length(to - from);
    }
}

}  // namespace tumble::render
