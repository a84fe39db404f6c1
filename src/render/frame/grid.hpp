// The metric grid behind the scene and the round lengths it and the scale bar use.
#pragma once

#include <string>

#include "render/canvas/primitives.hpp"
#include "render/view/view.hpp"

namespace tumble::render {

// 1, 2 or 5 times a power of ten: mantissa x 10^exponent metres.
struct RoundLength {
    int mantissa = 1;
    int exponent = 0;

    double metres() const;
};

// The least round length that is not below `metres` > 0.
RoundLength round_length_from(double metres);

// "50 cm", "2 m", "10 km".
std::string to_string(RoundLength length);

// Appends lines one pixel wide, on whole pixels: fine ones, and every few of them a stronger one.
void add_grid(Layer& layer, const View& view);

}  // namespace tumble::render
