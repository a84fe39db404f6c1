// A rectangle of a drawing that shows part of a plane: maps coordinates (y up) to pixels (y down) and clips to the
// rectangle.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "render/view/view.hpp"
#include "tumble/drawing.hpp"

namespace tumble::render {

struct PixelRect {
    double left = 0.0, top = 0.0, width = 0.0, height = 0.0;
};

// Draws a frame with a title and a caption, and returns the rectangle between them.
PixelRect draw_frame(Drawing& drawing, PixelRect rect, const std::string& title, const std::string& caption = {});

class Panel {
public:
    // Fits all points into the rectangle, with a margin and equal scales on both axes.
    Panel(Drawing& drawing, PixelRect rect, std::span<const DVec2> points);

    DVec2 to_pixels(DVec2 point) const;

    // Fills and lines are clipped to the rectangle. The outline must be convex.
    void fill(std::span<const DVec2> outline, Color fill, double outline_width, Color color);
    void dot(DVec2 at, double radius_px, Color color);
    void ring(DVec2 at, double radius_px, Color color);
    void line(DVec2 from, DVec2 to, double width_px, Color color);
    void dashed(DVec2 from, DVec2 to, double width_px, Color color);
    void arrow(DVec2 from, DVec2 direction, double length_px, Color color);  // direction of any length
    void label(DVec2 at, DVec2 offset_px, const std::string& text, double size, Color color);

private:
    Drawing& drawing_;
    PixelRect rect_;
    View view_;
    DVec2 middle_;  // of the rectangle, where the view's pixels count from
};

// The outline of a convex set grown by `radius`: its support points in directions over a full turn, each moved by
// `radius` in its direction. Corners are sharp for radius 0 and round otherwise.
template <class Support>
std::vector<DVec2> sampled_outline(const Support& support, double radius) {
    constexpr int kDirections = 720;
    std::vector<DVec2> outline;
    for (int k = 0; k < kDirections; ++k) {
        const SinCos turn = sin_cos(2.0 * kPi * (k + 0.5) / kDirections);
        const DVec2 direction{turn.cos, turn.sin};
        const DVec2 point = support(direction) + radius * direction;
        if (outline.empty() || !(outline.back() == point)) outline.push_back(point);
    }
    return outline;
}

// The core vertex of a shape farthest in a direction of the world, in world coordinates.
DVec2 world_support(const Shape& shape, const Pose& world_from_shape, DVec2 direction);

namespace ink {
inline constexpr Color kText{38, 50, 56};
inline constexpr Color kFaint{176, 190, 197};
inline constexpr Color kFrame{224, 230, 234};
inline constexpr Color kShapeA{30, 108, 181};
inline constexpr Color kShapeAFill{30, 108, 181, 56};
inline constexpr Color kShapeB{214, 110, 20};
inline constexpr Color kShapeBFill{214, 110, 20, 56};
inline constexpr Color kDifference{94, 84, 142};
inline constexpr Color kDifferenceFill{94, 84, 142, 36};
inline constexpr Color kSimplex{0, 137, 123};
inline constexpr Color kSimplexFill{0, 137, 123, 64};
inline constexpr Color kAnswer{198, 40, 40};
}  // namespace ink

}  // namespace tumble::render
