#include "render/panel.hpp"

#include <algorithm>

namespace tumble {

Panel::Panel(Drawing& drawing, PixelRect rect, std::span<const DVec2> points) : drawing_(drawing), rect_(rect) {
    constexpr double kMargin = 0.12;  // of the panel, on each side
    DVec2 lower = points.front(), upper = points.front();
    for (const DVec2 p : points) {
        lower = {std::min(lower.x, p.x), std::min(lower.y, p.y)};
        upper = {std::max(upper.x, p.x), std::max(upper.y, p.y)};
    }
    center_ = lower + 0.5 * (upper - lower);
    const double inner_width = (1.0 - 2.0 * kMargin) * rect.width, inner_height = (1.0 - 2.0 * kMargin) * rect.height;
    const double across = upper.x - lower.x, up = upper.y - lower.y;
    scale_ = std::min(across > 0.0 ? inner_width / across : 1e300, up > 0.0 ? inner_height / up : 1e300);
    if (scale_ == 1e300) scale_ = 1.0;
}

DVec2 Panel::to_pixels(DVec2 point) const {
    return {rect_.left + 0.5 * rect_.width + scale_ * (point.x - center_.x),
            rect_.top + 0.5 * rect_.height - scale_ * (point.y - center_.y)};
}

void Panel::frame(const std::string& title) {
    const double right = rect_.left + rect_.width, bottom = rect_.top + rect_.height;
    drawing_.polygon({{rect_.left, rect_.top}, {right, rect_.top}, {right, bottom}, {rect_.left, bottom}}, kTransparent, 1.0,
                     ink::kFrame);
    drawing_.text({rect_.left + 8.0, rect_.top + 19.0}, title, 13.0, ink::kText);
}

void Panel::fill(std::span<const DVec2> outline, Color fill, double outline_width, Color color) {
    std::vector<DVec2> pixels;
    for (const DVec2 p : outline) pixels.push_back(to_pixels(p));
    if (pixels.size() == 1) drawing_.disc(pixels[0], 2.0, color);
    if (pixels.size() == 2) drawing_.line(pixels[0], pixels[1], outline_width, color);
    if (pixels.size() >= 3) drawing_.polygon(std::move(pixels), fill, outline_width, color);
}

void Panel::dot(DVec2 at, double radius_px, Color color) { drawing_.disc(to_pixels(at), radius_px, color); }

void Panel::line(DVec2 from, DVec2 to, double width_px, Color color) {
    drawing_.line(to_pixels(from), to_pixels(to), width_px, color);
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

}  // namespace tumble
