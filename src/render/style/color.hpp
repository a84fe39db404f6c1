// Arithmetic on colours, and the pair of colours that a shape is painted with.
#pragma once

#include <optional>
#include <string_view>

#include "tumble/drawing.hpp"

namespace tumble::render {

// The inside of a shape and the line along its edge.
struct Paint {
    Color fill;
    Color outline;

    friend constexpr bool operator==(Paint, Paint) = default;
};

// A shape in one colour, without a visible outline.
constexpr Paint flat(Color color) { return {color, color}; }

// "#rgb" or "#rrggbb"; nothing if the text is neither.
std::optional<Color> parse_color(std::string_view text);

// From a (amount 0) to b (amount 1), each channel rounded. The amount is in [0, 1].
Color mix(Color a, Color b, double amount);

// The same colour, `opacity` (0 to 1) times as opaque.
Color faded(Color color, double opacity);

}  // namespace tumble::render
