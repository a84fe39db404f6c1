#include "render/labels/shape_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "debug/check.hpp"

namespace tumble::render {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The centre of row k is at k + 1/2. Numbers beyond the frame become its ends, so that they fit into an int.
int first_at_or_after(double at, int count) {
    return static_cast<int>(std::ceil(std::clamp(at, 0.0, count + 1.0) - 0.5));
}
int last_at_or_before(double at, int count) {
    return static_cast<int>(std::floor(std::clamp(at, -1.0, double(count)) - 0.5));
}

}  // namespace

void ShapeRows::meet(int row, double column) {
    Interval& interval = intervals_[static_cast<std::size_t>(row - first_row_)];
    interval.from = std::min(interval.from, column);
    interval.to = std::max(interval.to, column);
}

// Calls meet_row(row, centre of the row) for the rows of the frame between two heights.
template <class Meet>
void ShapeRows::for_rows(double top, double bottom, Meet&& meet_row) {
    const int end = first_row_ + static_cast<int>(intervals_.size());
    const int first = std::max(first_row_, first_at_or_after(top, end));
    const int last = std::min(end - 1, last_at_or_before(bottom, end));
    for (int row = first; row <= last; ++row) meet_row(row, row + 0.5);
}

void ShapeRows::meet_edge(DVec2 a, DVec2 b) {
    if (a.y > b.y) std::swap(a, b);
    for_rows(a.y, b.y, [&](int row, double y) {
        if (a.y == b.y) {
            meet(row, a.x);
            meet(row, b.x);
        } else {
            meet(row, a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
        }
    });
}

void ShapeRows::meet_circle(DVec2 center, double radius) {
    for_rows(center.y - radius, center.y + radius, [&](int row, double y) {
        const double half = std::sqrt(std::max(0.0, (radius - (y - center.y)) * (radius + (y - center.y))));
        meet(row, center.x - half);
        meet(row, center.x + half);
    });
}

void ShapeRows::add(std::vector<RowSpan>& spans, const View& view, const Shape& shape, const Pose& pose,
                    double line_width) {
    const auto count = static_cast<std::size_t>(shape.vertex_count());
    if (count == 0) return;
    double top = kInfinity, bottom = -kInfinity;
    core_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const DVec2 pixel = view.to_pixels(transform_point(pose, shape.vertex(static_cast<int>(i))));
        core_[i] = {0.5 * view.width + pixel.x, 0.5 * view.height - pixel.y};
        top = std::min(top, core_[i].y);
        bottom = std::max(bottom, core_[i].y);
    }
    const bool is_line = count == 2 && shape.radius() == 0.0f;
    const double radius = is_line ? 0.5 * line_width : view.scale * double{shape.radius()};
    first_row_ = first_at_or_after(top - radius, view.height);
    const int last_row = last_at_or_before(bottom + radius, view.height);
    if (last_row < first_row_) return;
    TUMBLE_CHECK(0 <= first_row_);
    TUMBLE_CHECK(last_row < view.height);
    intervals_.assign(static_cast<std::size_t>(last_row - first_row_) + 1, {kInfinity, -kInfinity});

    // A side of the tube about an edge that lies inwards is within the shape, and widens no interval.
    for (std::size_t i = 0; i < count; ++i) {
        const DVec2 from = core_[i], to = core_[(i + 1) % count], along = to - from;
        if (radius == 0.0) {
            meet_edge(from, to);
            continue;
        }
        meet_circle(from, radius);
        const double size = length(along);
        if (size == 0.0) continue;
        const DVec2 side = (radius / size) * DVec2{-along.y, along.x};
        meet_edge(from + side, to + side);
        meet_edge(from - side, to - side);
    }
    for (int row = first_row_; row <= last_row; ++row) {
        const Interval interval = intervals_[static_cast<std::size_t>(row - first_row_)];
        if (!(interval.from <= interval.to)) continue;
        const int first = first_at_or_after(interval.from, view.width);
        const int last = last_at_or_before(interval.to, view.width);
        if (first <= last) spans.push_back({row, first, last});
    }
}

}  // namespace tumble::render
