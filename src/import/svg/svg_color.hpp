// Converts SVG colours to those of scene files.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tumble::scene {

struct SvgColor {
    std::string rgb;     // "#rrggbb"
    double alpha = 1.0;  // 0: transparent, 1: opaque
};

// A colour as #rgb, #rgba, #rrggbb or #rrggbbaa, rgb(), rgba(), hsl(), hsla(), or by its name in CSS. Empty for any
// other text.
std::optional<SvgColor> parse_color(std::string_view text);

// A number from 0 to 1 or a percentage, limited to that range. Empty for any other text.
std::optional<double> parse_opacity(std::string_view text);

// The colour that an ink of this opacity has on white paper. `rgb` is "#rrggbb".
std::string mixed_with_white(const std::string& rgb, double opacity);

}  // namespace tumble::scene
