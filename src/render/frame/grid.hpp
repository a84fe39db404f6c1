// The metric grid behind the scene, and the round lengths of the grid and of the scale bar.
#pragma once

#include <string>

#include "render/canvas/primitives.hpp"
#include "render/style/theme.hpp"
#include "render/view/view.hpp"

namespace tumble::render {

// 1, 2 or 5 times a power of ten: mantissa x 10^exponent metres.
struct RoundLength {
    int mantissa = 1;
    int exponent = 0;

    double metres() const;
};

// The smallest round length of at least `metres`, which must be positive.
RoundLength round_length_from(double metres);

// "50 cm", "2 m", "10 km".
std::string to_string(RoundLength length);

// Appends lines one pixel wide, on whole pixels; every fourth or fifth one is stronger.
void add_grid(Layer& layer, const View& view, const Colors& colors = colors_of(Theme::light));

}  // namespace tumble::render
