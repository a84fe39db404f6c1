// Dots, lines and arrows over the shapes. Their size in pixels does not depend on the scale of the view.
#pragma once

#include "render/canvas/primitives.hpp"
#include "render/view/view.hpp"

namespace tumble::render {

inline constexpr double kMarkWidth = 1.8;  // of a line, pixels at 720 rows

class Marks {
public:
    // Dots have an outline in the colour of the background.
    Marks(Layer& layer, const View& view, Color background) : layer_(layer), view_(view), background_(background) {}

    double pixels(double at_720_rows) const { return at_720_rows * view_.detail(); }

    // Points in pixels, widths in pixels at 720 rows.
    void dot(DVec2 at, Color color);
    void line(DVec2 from, DVec2 to, double width, Color color);

    // The head is at most half as long as the arrow. An arrow shorter than its line is wide is not drawn.
    void arrow(DVec2 from, DVec2 to, Color color);

private:
    Layer& layer_;
    const View& view_;
    Color background_;
};

}  // namespace tumble::render
