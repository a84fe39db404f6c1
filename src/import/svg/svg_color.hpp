// Converts SVG colours to those of scene files.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tumble::scene {

// "#rrggbb" for #rgb and #rrggbb (with or without alpha, which is dropped), rgb(), rgba() and the colour names of CSS.
// Empty for any other text.
std::optional<std::string> parse_color(std::string_view text);

}  // namespace tumble::scene
