#include "render/view/clip.hpp"

#include <algorithm>

#include "debug/check.hpp"

namespace tumble::render {
namespace {

// The half-plane dot(normal, p) <= offset.
struct HalfPlane {
    DVec2 normal;
    double offset = 0.0;

    double outside(DVec2 p) const { return dot(normal, p) - offset; }
};

struct Frame {
    HalfPlane sides[4];
};

Frame grown_frame(const View& view, double margin) {
    const double x = 0.5 * view.width + margin, y = 0.5 * view.height + margin;
    return {{{{1.0, 0.0}, x}, {{-1.0, 0.0}, x}, {{0.0, 1.0}, y}, {{0.0, -1.0}, y}}};
}

std::vector<DVec2> clip_to(const std::vector<DVec2>& polygon, const HalfPlane& side) {
    std::vector<DVec2> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const DVec2 here = polygon[i], next = polygon[i + 1 < polygon.size() ? i + 1 : 0];
        const double out_here = side.outside(here), out_next = side.outside(next);
        if (out_here <= 0.0) kept.push_back(here);
        if ((out_here <= 0.0) != (out_next <= 0.0))
            kept.push_back(here + (out_here / (out_here - out_next)) * (next - here));
    }
    return kept;
}

}  // namespace

bool clip_segment(const View& view, double margin, DVec2& from, DVec2& to) {
    double enter = 0.0, leave = 1.0;
    for (const HalfPlane& side : grown_frame(view, margin).sides) {
        const double out_from = side.outside(from), out_to = side.outside(to);
        if (out_from > 0.0 && out_to > 0.0) return false;
        if (out_from > 0.0) enter = std::max(enter, out_from / (out_from - out_to));
        if (out_to > 0.0) leave = std::min(leave, out_from / (out_from - out_to));
    }
    if (enter > leave) return false;
    TUMBLE_CHECK(0.0 <= enter);
    TUMBLE_CHECK(leave <= 1.0);
    const DVec2 start = from, along = to - from;
    from = start + enter * along;
    if (leave < 1.0) to = start + leave * along;
    return true;
}

std::vector<DVec2> clip_polygon(const View& view, double margin, std::vector<DVec2> polygon) {
    for (const HalfPlane& side : grown_frame(view, margin).sides) polygon = clip_to(polygon, side);
    return polygon;
}

}  // namespace tumble::render
