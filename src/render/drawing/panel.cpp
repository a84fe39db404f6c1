#include "render/drawing/panel.hpp"

#include <algorithm>

#include "debug/check.hpp"
#include "render/view/clip.hpp"

namespace tumble::render {

PixelRect draw_frame(Drawing& drawing, PixelRect rect, const std::string& title, const std::string& caption) {
    constexpr double kTitle = 28.0, kCaption = 26.0;
    const double right = rect.left + rect.width, bottom = rect.top + rect.height;
    drawing.polygon({{rect.left, rect.top}, {right, rect.top}, {right, bottom}, {rect.left, bottom}}, kTransparent, 1.0,
                    ink::kFrame);
    drawing.text({rect.left + 8.0, rect.top + 19.0}, title, 13.0, ink::kText);
    drawing.text({rect.left + 8.0, bottom - 10.0}, caption, 12.0, ink::kText);
    return {rect.left, rect.top + kTitle, rect.width, rect.height - kTitle - (caption.empty() ? 0.0 : kCaption)};
}

Panel::Panel(Drawing& drawing, PixelRect rect, std::span<const DVec2> points)
    : drawing_(drawing), rect_(rect), middle_{rect.left + 0.5 * rect.width, rect.top + 0.5 * rect.height} {
    constexpr double kMargin = 0.1;  // of the panel, on each side
    TUMBLE_CHECK(!points.empty());
    TUMBLE_CHECK(rect.width > 0.0);
    TUMBLE_CHECK(rect.height > 0.0);
    DVec2 lower = points.front(), upper = points.front();
    for (const DVec2 p : points) {
        lower = {std::min(lower.x, p.x), std::min(lower.y, p.y)};
        upper = {std::max(upper.x, p.x), std::max(upper.y, p.y)};
    }
    const DVec2 size = upper - lower;
    const double inner = 1.0 - 2.0 * kMargin;
    const double per_pixel = std::max(size.x / (inner * rect.width), size.y / (inner * rect.height));
    view_ = {lower + 0.5 * size, per_pixel > 0.0 ? 1.0 / per_pixel : 1.0, static_cast<int>(rect.width),
             static_cast<int>(rect.height)};
}

DVec2 Panel::to_pixels(DVec2 point) const {
    const DVec2 up = view_.to_pixels(point);
    return middle_ + DVec2{up.x, -up.y};
}

void Panel::fill(std::span<const DVec2> outline, Color fill, double outline_width, Color color) {
    if (outline.size() == 1) dot(outline[0], 2.0, color);
    if (outline.size() == 2) line(outline[0], outline[1], outline_width, color);
    if (outline.size() < 3) return;
    std::vector<DVec2> pixels;
    for (const DVec2 p : outline) pixels.push_back(view_.to_pixels(p));
    const bool is_whole = std::ranges::all_of(pixels, [this](DVec2 p) { return view_.is_in_view(p, 0.0); });
    pixels = clip_polygon(view_, 0.0, std::move(pixels));
    for (DVec2& p : pixels) p = middle_ + DVec2{p.x, -p.y};
    if (pixels.size() >= 3) drawing_.polygon(std::move(pixels), fill, is_whole ? outline_width : 0.0, color);
    if (is_whole) return;
    // Only the edges of the shape are lines; the cuts along the rectangle are not.
    for (std::size_t i = 0; i < outline.size(); ++i)
        line(outline[i], outline[i + 1 < outline.size() ? i + 1 : 0], outline_width, color);
}

void Panel::dot(DVec2 at, double radius_px, Color color) {
    if (view_.is_in_view(view_.to_pixels(at), 0.0)) drawing_.disc(to_pixels(at), radius_px, color);
}

void Panel::ring(DVec2 at, double radius_px, Color color) {
    if (view_.is_in_view(view_.to_pixels(at), 0.0)) drawing_.disc(to_pixels(at), radius_px, kTransparent, 1.5, color);
}

void Panel::line(DVec2 from, DVec2 to, double width_px, Color color) {
    DVec2 start = view_.to_pixels(from), end = view_.to_pixels(to);
    if (!clip_segment(view_, 0.0, start, end)) return;
    drawing_.line(middle_ + DVec2{start.x, -start.y}, middle_ + DVec2{end.x, -end.y}, width_px, color);
}

void Panel::dashed(DVec2 from, DVec2 to, double width_px, Color color) {
    drawing_.dashed_line(to_pixels(from), to_pixels(to), width_px, color);
}

void Panel::arrow(DVec2 from, DVec2 direction, double length_px, Color color) {
    const double norm = length(direction);
    if (!(norm > 0.0)) return;
    const DVec2 start = to_pixels(from);
    drawing_.arrow(start, start + (length_px / norm) * DVec2{direction.x, -direction.y}, 2.0, color);
}

void Panel::label(DVec2 at, DVec2 offset_px, const std::string& text, double size, Color color) {
    if (!view_.is_in_view(view_.to_pixels(at), 0.0)) return;
    drawing_.text(to_pixels(at) + offset_px, text, size, color, TextAnchor::middle);
}

DVec2 world_support(const Shape& shape, const Pose& world_from_shape, DVec2 direction) {
    DVec2 best = transform_point(world_from_shape, shape.vertex(0));
    for (int i = 1; i < shape.vertex_count(); ++i) {
        const DVec2 candidate = transform_point(world_from_shape, shape.vertex(i));
        if (dot(candidate - best, direction) > 0.0) best = candidate;
    }
    return best;
}

}  // namespace tumble::render
