// Dots, lines and arrows over the shapes, of the same size in every view.
#pragma once

#include "render/canvas/primitives.hpp"
#include "render/view/view.hpp"

namespace tumble::render {

inline constexpr double kMarkWidth = 1.8;  // of a line, pixels at 720 rows

class Marks {
public:
    Marks(Layer& layer, const View& view) : layer_(layer), view_(view) {}

    double pixels(double at_720_rows) const { return at_720_rows * view_.detail(); }

    // Points in pixels, widths in pixels at 720 rows.
    void dot(DVec2 at, Color color);
    void line(DVec2 from, DVec2 to, double width, Color color);

    // The head is no longer than half the arrow; what is shorter than a line is wide is left out.
    void arrow(DVec2 from, DVec2 to, Color color);

private:
    Layer& layer_;
    const View& view_;
};

}  // namespace tumble::render
