#include "render/style/color.hpp"

#include <cmath>

#include "debug/check.hpp"
namespace tumble::render {
namespace {

std::optional<int> hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return std::nullopt;
}

std::uint8_t to_channel(double value) {
    TUMBLE_CHECK(0.0 <= value);
    TUMBLE_CHECK(value <= 255.0);
    return static_cast<std::uint8_t>(std::floor(value + 0.5));
}

std::uint8_t mix_channel(std::uint8_t a, std::uint8_t b, double amount) { return to_channel(a + amount * (b - a)); }

}  // namespace

std::optional<Color> parse_color(std::string_view text) {
    const bool brief = text.size() == 4;
    if ((!brief && text.size() != 7) || text[0] != '#') return std::nullopt;
    std::uint8_t channel[3] = {};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::optional<int> high = hex_digit(text[brief ? 1 + i : 1 + 2 * i]);
        const std::optional<int> low = hex_digit(text[brief ? 1 + i : 2 + 2 * i]);
        if (!high || !low) return std::nullopt;
        channel[i] = static_cast<std::uint8_t>(16 * *high + *low);
    }
    return Color{channel[0], channel[1], channel[2]};
}

Color mix(Color a, Color b, double amount) {
    return {mix_channel(a.r, b.r, amount), mix_channel(a.g, b.g, amount), mix_channel(a.b, b.b, amount),
            mix_channel(a.a, b.a, amount)};
}

Color faded(Color color, double opacity) {
    color.a = to_channel(color.a * opacity);
    return color;
}

}  // namespace tumble::render
