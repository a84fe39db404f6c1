// A colour of 8 bits per channel with straight alpha.
#pragma once

#include <cstdint>

namespace tumble {

struct Color {
    std::uint8_t r = 0, g = 0, b = 0;
    std::uint8_t a = 255;

    friend constexpr bool operator==(Color, Color) = default;
};

inline constexpr Color kTransparent{0, 0, 0, 0};

}  // namespace tumble
